#pragma once

#include "app/files/import/import_answer.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

struct ImportedModel;

/// Vertices and faces of a file in any order, before triangulation.
class FaceSoup {
  public:
    static constexpr int kNone = -1;

    std::vector<Vec3> positions;
    std::vector<Vec2> uvs;                      ///< referenced by corners
    std::vector<Vec2> vertexUvs;                ///< by vertex, for corners without a reference
    std::vector<Eigen::Vector4f> vertexColors;  ///< linear, by vertex; fewer at the end, or none
    std::vector<int> aliases;  ///< by vertex: an equal one at the same place, or itself
    std::vector<Eigen::Vector4f> faceColors;  ///< the same by face, if vertices have none

    /// Faces that end from now on belong to the object of that name.
    void enterObject(const std::string& name);
    /// Begins a new object; a name that is taken gets a number.
    void beginObject(const std::string& name);
    /// By the numbers in the triangles; empty if no object was entered.
    const std::vector<std::string>& objectNames() const { return objectNames_; }
    /// Adds a corner to the current face; both are indices, `uv` may be kNone.
    void addCorner(int vertex, int uv = kNone);
    /// Ends the face; drops one with fewer than three corners. `material`: its index, or kNone.
    void endFace(int material = kNone);
    /// Adds the triangles of a strip. A negative number begins another one.
    void addStrips(const std::vector<double>& corners);
    std::size_t faceCount() const { return ends_.size(); }

    /// Divides the faces into triangles. One that crosses itself, or encloses no area, becomes a
    /// fan. Throws InputError without a face, or if a corner is missing.
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

/// A vertex number from a number of a file; kNone if invalid.
int cornerOf(double number);

/// A colour with opacity, from display colours to linear light.
Eigen::Vector4f linearOf(const Eigen::Vector4d& display);
/// Converts display colours to linear light: from 0 to 1, or bytes, depending on the largest one.
/// kNoColor becomes white.
void makeLinear(std::vector<Eigen::Vector4f>& display);
/// Marks a vertex or a face without a colour, until makeLinear().
inline const Eigen::Vector4f kNoColor = Eigen::Vector4f::Constant(-1);

/// Moves the triangles and objects of the faces to a model. Throws like triangles().
void takeFaces(FaceSoup& faces, ImportedModel& model);
/// Rounds positions near the origin to floats, the precision of the text; far from it that would
/// change the shape.
void roundNearOrigin(TriangleSoup& soup);
/// Throws InputError if positions that were read as floats are so far from the origin that the
/// shape is lost.
void requireFineFloats(std::span<const Vec3> positions);

/// Reads an OBJ file: faces of any number of corners, counted from the start or backwards; colours
/// behind vertices, 0 to 1 or 0 to 255; texture coordinates; materials of .mtl files in its folder
/// and below. Points, lines, normals and groups are skipped; unknown statements become a remark.
/// Throws InputError for invalid numbers and missing corners.
ImportedModel readObj(const std::filesystem::path& file);

/// Reads a text OFF file, with faces of any number of corners, and colours of vertices or faces if
/// present. Throws InputError for invalid numbers, a binary file, other than three dimensions, and
/// a truncated file.
ImportedModel readOff(const std::filesystem::path& file);

/// Reads a PLY file: text or binary, of any byte order, line end and order of elements; faces of
/// any number of corners and triangle strips; colours of vertices or faces, texture coordinates of
/// vertices or corners, and the image of a comment TextureFile. Throws InputError if the file is
/// shorter than its header says.
ImportedModel readPly(const std::filesystem::path& file);

/// Reads an STL file: binary, with facet colours if present, also with bytes after the last facet;
/// or text in upper or lower case, with comments and blank lines. Normals are computed from the
/// facets. Throws InputError for a truncated file and invalid numbers.
ImportedModel readStl(const std::filesystem::path& file);

/// Reads the scene of a glTF 2.0 or GLB file at rest: placed nodes, skins by their joints, morph
/// targets by their weights, quantized or sparse numbers, colours, materials and the first texture
/// of each. Points and lines are skipped. Throws InputError for broken files, and for an
/// unsupported extension that changes the shape.
ImportedModel readGltf(const std::filesystem::path& file);

}  // namespace kerf::app
