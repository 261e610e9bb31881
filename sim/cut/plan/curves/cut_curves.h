#pragma once

#include "sim/cut/cut_types.h"
#include "sim/cut/exact/directed_edges.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The place of a node of the new surface.
enum class NodeKind {
    edge,    ///< a mesh edge pierces a strip triangle (E)
    face,    ///< a strip edge pierces a mesh triangle (F)
    vertex,  ///< a mesh vertex, on the front (V)
    wall,    ///< inside the body
};

/// A vertex of the new surface, before it has a number in the mesh; position and velocity as those
/// of mesh vertices.
struct CutNode {
    NodeKind kind = NodeKind::wall;  ///< its place
    int a = -1;                      ///< edge: its first end; face: the triangle; vertex: itself
    int b = -1;                      ///< edge: its second end
    double t = 0;                    ///< edge: position = a + t (b - a)
    Vec3 weights = Vec3::Zero();     ///< face: barycentric, in the order of its corners
    int stripEdge = -1;              ///< face: the strip edge that pierces it
    double u = 0;                    ///< face: parameter along the strip edge
    bool onSeam = false;             ///< divides a wall that is not cut (addSeams)
    Vec2 layout = Vec2::Zero();      ///< place in the layout plane of the strip [m]
    Vec3 position = Vec3::Zero();    ///< [m]
    Vec3 rest = Vec3::Zero();        ///< [m]
    Vec3 velocity = Vec3::Zero();    ///< [m/s]
};

/// A piece of the curve in which a mesh triangle and a strip triangle meet. It runs with the
/// inside of the body on its left in the strip: its direction is n_strip x n_mesh.
struct Segment {
    int triangle;       ///< slot in the mesh
    int stripTriangle;  ///< place in the strip
    int from;           ///< node
    int to;             ///< node
};

/// A point in which a mesh edge pierces a triangle of the strip.
struct EdgeHit {
    int stripTriangle;  ///< place in the strip
    int node;           ///< the E node there
};

/// All intersection curves of strip and surface. Containers are ordered, since iteration order
/// affects the numbering of the result.
struct CutCurves {
    std::vector<CutNode> nodes;                   ///< all nodes of the new surface
    std::vector<Segment> segments;                ///< all pieces of the curves
    std::map<Edge, std::vector<EdgeHit>> onEdge;  ///< hits of each mesh edge, along it
    std::map<std::pair<int, int>, int> onFace;    ///< node by (triangle, strip edge)
    /// The segments of each triangle that the step replaces.
    std::map<int, std::vector<int>> segmentsOfTriangle;
    VertexNumbers nodeOfVertex;  ///< V nodes by mesh vertex

    /// The V node of a mesh vertex, made where there is none yet.
    int vertexNode(const SurfaceMesh& mesh, int v, const Vec2& layout);
    /// Adds nodes that were numbered after the last one.
    void append(const std::vector<CutNode>& more);
};

/// The key that copies of a node share: the first copies of its edge's or face's corners, and the
/// strip's triangle or edge there.
using PointKey = std::array<int, 4>;
/// By node; -1 throughout for V nodes and inner ones of walls.
std::vector<PointKey> pointKeys(const SurfaceMesh& mesh, const CutCurves& curves);

/// A V node.
CutNode nodeAtVertex(const SurfaceMesh& mesh, int v, const Vec2& layout);

}  // namespace kerf::cut
