#pragma once

#include "sim/base/math.h"

namespace kerf {

/// Has the present positions and velocities of a mesh with stale ones, and delivers them by
/// SurfaceMesh::setState().
class VertexSource {
  public:
    VertexSource() = default;
    virtual ~VertexSource() = default;
    VertexSource(const VertexSource&) = delete;
    VertexSource& operator=(const VertexSource&) = delete;

    /// Delivers the state of at least these vertices, in one go.
    virtual void bring(std::span<const int> vertices) = 0;
    /// Delivers the state of all stale vertices.
    virtual void bringAll() = 0;
};

/// The kind of a triangle: loaded skin, or a wall made by a cut.
enum class SurfaceKind : std::uint8_t { skin = 0, wall = 1 };

/// The corner of a triangle that follows one, counter-clockwise.
inline int cornerAfter(int corner) {
    return corner == 2 ? 0 : corner + 1;
}
/// The corner of a triangle before one.
inline int cornerBefore(int corner) {
    return corner == 0 ? 2 : corner - 1;
}

/// A closed triangle mesh with half-edge adjacency, made to be cut.
///
/// Half-edge h = 3 * triangle + corner runs from that corner to the next one. Every half-edge has a
/// twin. Triangles are never moved: a removed one stays as a dead slot, so that indices held by the
/// solver stay valid. Vertices carry current position, rest position and velocity. A cut makes
/// copies of the vertices along it; those of one vertex form a group of copies, which represents
/// one point of the uncut body.
///
/// While a stroke of the open cut is unfinished (CutSettings::openCut), its walls exist for the
/// cutter only: they are absent from the body, which has an open surface of the present triangles.
///
/// While a solver moves the body on the GPU, positions and velocities may be stale: they are
/// fetched when read. Only meshes without stale state may be read by several threads.
class SurfaceMesh {
  public:
    SurfaceMesh() = default;
    /// Copies have room to grow (withGrowthRoom).
    SurfaceMesh(const SurfaceMesh& other);
    SurfaceMesh(SurfaceMesh&&) noexcept = default;
    SurfaceMesh& operator=(const SurfaceMesh&) = default;
    SurfaceMesh& operator=(SurfaceMesh&&) noexcept = default;
    ~SurfaceMesh() = default;

    /// Builds adjacency. The triangles must form a closed, oriented 2-manifold (see
    /// inspectTriangles); throws std::invalid_argument otherwise. Rest positions = positions.
    static SurfaceMesh fromTriangles(const std::vector<Vec3>& positions,
                                     const std::vector<Triangle>& triangles);

    // Sizes. Slots include dead triangles and vertices that no triangle uses.
    int vertexCount() const { return static_cast<int>(positions_.size()); }
    int triangleSlots() const { return static_cast<int>(triangles_.size()); }
    int aliveTriangles() const { return aliveTriangles_; }
    /// Whether a vertex is an original one, not made by a cut.
    bool isOriginal(int v) const { return v < originalVertices_; }

    // Per vertex.
    /// The current position [m].
    const Vec3& position(int v) const {
        if (isOld(v)) [[unlikely]] {
            bringAll();
        }
        return positions_[v];
    }
    const Vec3& restPosition(int v) const { return restPositions_[v]; }  ///< [m]
    /// The current velocity [m/s].
    const Vec3& velocity(int v) const {
        if (isOld(v)) [[unlikely]] {
            bringAll();
        }
        return velocities_[v];
    }
    void setPosition(int v, const Vec3& p) { positions_[v] = p; }
    void setRestPosition(int v, const Vec3& p) { restPositions_[v] = p; }
    void setVelocity(int v, const Vec3& u) { velocities_[v] = u; }
    /// Exchanges current and rest positions.
    void exchangeShapes() {
        bringAll();
        positions_.swap(restPositions_);
    }
    const std::vector<Vec3>& positions() const {
        bringAll();
        return positions_;
    }
    const std::vector<Vec3>& restPositions() const { return restPositions_; }
    /// Whether a tear made it, not a blade.
    bool isTorn(int v) const { return static_cast<std::size_t>(v) < torn_.size() && torn_[v] != 0; }
    /// One half-edge that starts at v, -1 for an unused vertex.
    int outgoing(int v) const { return outgoing_[v]; }

    // Per triangle.
    bool alive(int t) const { return triangles_[t][0] >= 0; }
    const Triangle& triangle(int t) const { return triangles_[t]; }
    SurfaceKind kind(int t) const { return kinds_[t]; }
    /// Which cut made this wall triangle: 2 * stroke + side (0: W+, 1: W-); -1 on skin.
    int wallLabel(int t) const { return wallLabels_[t]; }
    /// Whether the triangle is a wall of the open stroke.
    bool absent(int t) const {
        return openStroke_ >= 0 && kinds_[t] == SurfaceKind::wall &&
               wallLabels_[t] / 2 == openStroke_;
    }
    /// Whether the triangle is alive and part of the body's surface.
    bool present(int t) const { return alive(t) && !absent(t); }
    /// The stroke whose walls are absent, -1 for none.
    int openStroke() const { return openStroke_; }
    void setOpenStroke(int stroke) { openStroke_ = stroke; }

    // Half-edges.
    /// The triangle of a half-edge, by an unsigned division.
    static int triangleOf(int h) { return static_cast<int>(static_cast<unsigned>(h) / 3); }
    static int next(int h) { return cornerOf(h) == 2 ? h - 2 : h + 1; }
    static int previous(int h) { return cornerOf(h) == 0 ? h + 2 : h - 1; }
    int origin(int h) const { return triangles_[triangleOf(h)][cornerOf(h)]; }
    int target(int h) const { return triangles_[triangleOf(h)][cornerAfter(cornerOf(h))]; }
    int apex(int h) const { return triangles_[triangleOf(h)][cornerBefore(cornerOf(h))]; }
    int twin(int h) const { return twins_[triangleOf(h)][cornerOf(h)]; }
    /// The twins of the three half-edges of a triangle.
    const std::array<int, 3>& twins(int t) const { return twins_[t]; }
    /// Next outgoing half-edge of the same origin, counter-clockwise seen from outside.
    int rotate(int h) const { return twins_[triangleOf(h)][cornerBefore(cornerOf(h))]; }
    /// The half-edge u -> v, or -1.
    int findHalfEdge(int u, int v) const;

    /// Calls f(h) for each half-edge that starts at v.
    template <class F>
    void forEachOutgoing(int v, F&& f) const {
        const int first = outgoing_[v];
        if (first < 0) {
            return;
        }
        int h = first;
        do {
            f(h);
            h = rotate(h);
        } while (h != first);
    }

    // Numbers that are elsewhere.
    /// From now on `source` has the positions and velocities of all vertices. It must outlive the
    /// mesh and its copies, or until nothing is stale.
    void leaveTo(VertexSource& source);
    /// Sets the state of a vertex from the source.
    void setState(int v, const Vec3& position, const Vec3& velocity);
    bool isOld(int v) const { return source_ != nullptr && old_[v] != 0; }
    /// Whether nothing is stale.
    bool isWhole() const { return source_ == nullptr; }
    /// Fetches what is stale of these in one go; reading a stale one fetches all.
    void bring(std::span<const int> vertices) const;
    void bringAll() const;

    // Editing, for the cutter. Adjacency is the caller's business until the edit is complete.
    int addVertex(const Vec3& position, const Vec3& rest, const Vec3& velocity);
    int addTriangle(const Triangle& corners, SurfaceKind kind, int wallLabel);
    void removeTriangle(int t);
    /// Removes a vertex without triangles from its copies and from use.
    void removeVertex(int v);
    void setCorner(int t, int corner, int v) { triangles_[t][corner] = v; }
    void setCorners(int t, const Triangle& corners) { triangles_[t] = corners; }
    void setTwin(int h, int g) { twins_[triangleOf(h)][cornerOf(h)] = g; }
    /// Makes h and g each other's twins.
    void link(int h, int g) {
        setTwin(h, g);
        setTwin(g, h);
    }
    void setOutgoing(int v, int h) { outgoing_[v] = h; }

    /// Vertices from this index on are torn, except copies of older ones that are not.
    void noteTorn(int firstVertex);

    /// Makes a and b, and all copies of either, copies of one point.
    void joinCopies(int a, int b);
    /// Makes v a separate point.
    void leaveCopies(int v);
    /// The group of v and its copies, -1 for a vertex without copies.
    int copyGroup(int v) const { return copyGroup_[v]; }
    /// The first of v and its copies, which represents them all; v without copies.
    int firstCopy(int v) const {
        return copyGroup_[v] < 0 ? v : copyMembers_[copyGroup_[v]].front();
    }
    /// Members of a group, in the order in which they joined.
    const std::vector<int>& copiesOfGroup(int group) const { return copyMembers_[group]; }

    /// Writes or reads all of it (ByteArchive); nothing of it may be stale.
    template <class Archive>
    void archive(Archive& io) {
        io(old_, positions_, restPositions_, velocities_, outgoing_, triangles_, twins_, kinds_,
           wallLabels_, copyGroup_, copyMembers_, originalVertices_, aliveTriangles_, openStroke_,
           torn_);
    }

  private:
    // Without divisions by three but the one that tells the triangle.
    static int cornerOf(int h) { return h - 3 * triangleOf(h); }

    void reserve(std::size_t vertices, std::size_t triangles);
    int groupOf(int v);

    mutable VertexSource* source_ = nullptr;  ///< null while nothing is stale
    std::vector<std::uint8_t> old_;  ///< of each vertex: the source has its position and velocity
    std::vector<Vec3> positions_;
    std::vector<Vec3> restPositions_;
    std::vector<Vec3> velocities_;
    std::vector<int> outgoing_;
    std::vector<Triangle> triangles_;
    std::vector<std::array<int, 3>> twins_;
    std::vector<SurfaceKind> kinds_;
    std::vector<int> wallLabels_;
    std::vector<int> copyGroup_;
    std::vector<std::vector<int>> copyMembers_;
    int originalVertices_ = 0;
    int aliveTriangles_ = 0;
    int openStroke_ = -1;
    std::vector<std::uint8_t> torn_;  ///< of each vertex up to the last torn one
};

/// Number of triangles around v.
int valence(const SurfaceMesh& mesh, int v);
/// Whether there are triangles around v and all of them are absent.
bool hidden(const SurfaceMesh& mesh, int v);

/// The slots of the living triangles, ascending.
std::vector<int> livingTriangles(const SurfaceMesh& mesh);
/// The slots of the absent triangles, the walls of the open stroke, ascending.
std::vector<int> absentTriangles(const SurfaceMesh& mesh);

}  // namespace kerf
