#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

struct ImportedModel;

/// Vertices and faces of a file in whatever order they come, until they become triangles.
class FaceSoup {
  public:
    static constexpr int kNone = -1;

    std::vector<Vec3> positions;
    std::vector<Vec2> uvs;                      ///< that corners name
    std::vector<Vec2> vertexUvs;                ///< by vertex, for corners that name none
    std::vector<Eigen::Vector4f> vertexColors;  ///< linear, by vertex; fewer at the end, or none
    std::vector<int> aliases;  ///< by vertex: one at the same place that it is, or itself; or none
    std::vector<Eigen::Vector4f> faceColors;  ///< the same by face, where vertices have none

    /// The faces that end from now on are of the object of that name.
    void enterObject(const std::string& name);
    /// Begins an object that differs from all before; a name that is taken gets a number.
    void beginObject(const std::string& name);
    /// By the numbers in the triangles; none where no object was entered.
    const std::vector<std::string>& objectNames() const { return objectNames_; }
    /// Adds a corner to the face that is being made; both are indices, `uv` perhaps kNone.
    void addCorner(int vertex, int uv = kNone);
    /// Ends the face; one with fewer than three corners is left out. `material`: its index, or
    /// kNone.
    void endFace(int material = kNone);
    std::size_t faceCount() const { return ends_.size(); }

    /// Divides the faces into triangles. One that crosses itself, or encloses no area, becomes a
    /// fan. Throws InputError where there is no face, or a corner is not there.
    TriangleSoup triangles();

  private:
    void requireCorners() const;
    std::vector<Triangle> divided(std::size_t first, std::size_t end) const;
    void addTriangle(std::size_t face, const Triangle& corners);
    int vertexAt(std::size_t corner) const;
    Eigen::Vector2f uvAt(std::size_t corner) const;
    Eigen::Vector4f colorAt(std::size_t face, int vertex) const;

    TriangleSoup soup_;
    std::vector<int> corners_;       ///< of all faces: vertices
    std::vector<int> cornerUvs_;     ///< the same
    std::vector<std::size_t> ends_;  ///< where the corners of each face end
    std::vector<int> materials_;     ///< by face
    bool hasMaterials_ = false;
    std::vector<int> objects_;  ///< by face
    int object_ = 0;
    std::vector<std::string> objectNames_;
    std::map<std::string, int> objectNumbers_;
};

/// The number of a vertex that a number of a file is; kNone where it is none.
int cornerOf(double number);

/// A colour and its opacity, from what displays take to linear light.
Eigen::Vector4f linearOf(const Eigen::Vector4d& display);
/// Turns colours as displays show them into linear light: shares from 0 to 1, or bytes, as the
/// largest one tells. kNoColor becomes white.
void makeLinear(std::vector<Eigen::Vector4f>& display);
/// Marks a vertex or a face without a colour, until makeLinear().
inline const Eigen::Vector4f kNoColor = Eigen::Vector4f::Constant(-1);

/// The triangles and objects of the faces become those of a model. Throws as triangles().
void takeFaces(FaceSoup& faces, ImportedModel& model);
/// Rounds positions near the origin to floats, for a text that says as much; those far from it
/// would make another shape.
void roundNearOrigin(TriangleSoup& soup);
/// Throws InputError where positions that were read as floats lie so far from the origin that they
/// are another shape.
void requireFineFloats(std::span<const Vec3> positions);

}  // namespace kerf::app
