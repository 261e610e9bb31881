#include "sim/mesh/invariants.h"

#include "sim/mesh/piece_labels.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

/// Half-edges of the living triangles, grouped by the vertex that they start at.
struct OutgoingLists {
    std::vector<int> first;      ///< shape [vertices + 1]
    std::vector<int> halfEdges;  ///< shape [3 * living triangles]
};

template <class F>
void forEachHalfEdge(const SurfaceMesh& mesh, F&& f) {
    for (const int t : livingTriangles(mesh)) {
        f(3 * t);
        f(3 * t + 1);
        f(3 * t + 2);
    }
}

OutgoingLists listOutgoing(const SurfaceMesh& mesh) {
    OutgoingLists lists;
    lists.first.assign(mesh.vertexCount() + 1, 0);
    forEachHalfEdge(mesh, [&](int h) { ++lists.first[mesh.origin(h) + 1]; });
    std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
    lists.halfEdges.resize(lists.first.back());
    std::vector<int> cursor(lists.first.begin(), lists.first.end() - 1);
    forEachHalfEdge(mesh, [&](int h) { lists.halfEdges[cursor[mesh.origin(h)]++] = h; });
    return lists;
}

std::string edgeName(const SurfaceMesh& mesh, int h) {
    return "half-edge " + std::to_string(h) + " (" + std::to_string(mesh.origin(h)) + " -> " +
           std::to_string(mesh.target(h)) + ")";
}

std::string vertexName(int v) {
    return "vertex " + std::to_string(v);
}

/// Corners must be valid before anything may follow them.
std::string checkCorners(const SurfaceMesh& mesh) {
    for (const int t : livingTriangles(mesh)) {
        for (const int v : mesh.triangle(t)) {
            if (v < 0 || v >= mesh.vertexCount()) {
                return "triangle " + std::to_string(t) + " names " + vertexName(v) + " of " +
                       std::to_string(mesh.vertexCount());
            }
        }
    }
    return "";
}

bool isLivingHalfEdge(const SurfaceMesh& mesh, int h) {
    return h >= 0 && h < 3 * mesh.triangleSlots() && mesh.alive(h / 3);
}

std::string checkTwinOf(const SurfaceMesh& mesh, int h) {
    const int g = mesh.twin(h);
    if (!isLivingHalfEdge(mesh, g)) {
        return edgeName(mesh, h) + " has no living twin";
    }
    if (mesh.twin(g) != h) {
        return edgeName(mesh, h) + " has a twin whose twin is another: " + edgeName(mesh, g);
    }
    if (mesh.origin(g) != mesh.target(h) || mesh.target(g) != mesh.origin(h)) {
        return edgeName(mesh, h) + " has a twin with other end points: " + edgeName(mesh, g);
    }
    return "";
}

/// Number of half-edges met by turning once around v from `first`; limit + 1 where the walk does
/// not come back within `limit` of them.
int walkLength(const SurfaceMesh& mesh, int first, int limit) {
    int h = first;
    for (int steps = 1; steps <= limit; ++steps) {
        h = mesh.rotate(h);
        if (h == first) {
            return steps;
        }
        if (!isLivingHalfEdge(mesh, h)) {
            break;
        }
    }
    return limit + 1;
}

std::string checkUmbrellaOf(const SurfaceMesh& mesh, int v, int valence) {
    const int first = mesh.outgoing(v);
    if (valence == 0) {
        return first < 0 ? "" : vertexName(v) + " has no triangle but an outgoing half-edge";
    }
    if (!isLivingHalfEdge(mesh, first) || mesh.origin(first) != v) {
        return vertexName(v) + " has no valid outgoing half-edge";
    }
    const int met = walkLength(mesh, first, valence);
    if (met != valence) {
        return "the umbrella around " + vertexName(v) + " holds " +
               (met > valence ? "no closed ring of " : std::to_string(met) + " of ") + "its " +
               std::to_string(valence) + " triangles";
    }
    return "";
}

bool isFinite(const SurfaceMesh& mesh, int v) {
    return mesh.position(v).allFinite() && mesh.restPosition(v).allFinite() &&
           mesh.velocity(v).allFinite();
}

/// The corner at the origin of h: its edge, its umbrella, and that h belongs to the umbrella.
std::string checkCornerOf(const SurfaceMesh& mesh, int h) {
    const int v = mesh.origin(h);
    if (v < 0 || v >= mesh.vertexCount() || !isFinite(mesh, v)) {
        return edgeName(mesh, h) + " starts at no vertex with finite coordinates";
    }
    if (std::string fault = checkTwinOf(mesh, h); !fault.empty()) {
        return fault;
    }
    const int first = mesh.outgoing(v);
    if (!isLivingHalfEdge(mesh, first) || mesh.origin(first) != v) {
        return vertexName(v) + " has no valid outgoing half-edge";
    }
    std::vector<int> targets;
    bool met = false;
    int at = first;
    do {
        met = met || at == h;
        targets.push_back(mesh.target(at));
        at = mesh.rotate(at);
    } while (at != first && isLivingHalfEdge(mesh, at) && mesh.origin(at) == v &&
             static_cast<int>(targets.size()) < 3 * mesh.triangleSlots());
    if (at != first || !met) {
        return "the umbrella around " + vertexName(v) + " is not closed or not the only one";
    }
    std::sort(targets.begin(), targets.end());
    if (std::adjacent_find(targets.begin(), targets.end()) != targets.end() ||
        std::binary_search(targets.begin(), targets.end(), v)) {
        return "two edges of " + vertexName(v) + " have the same end points";
    }
    return "";
}

/// About which the volume of each piece is measured: any point where it is closed.
std::vector<Vec3> volumeApexes(const SurfaceMesh& mesh, const PieceMap& map) {
    std::vector<Vec3> apexes(map.pieces.size(), Vec3::Zero());
    const std::vector<int> onBorder = verticesOnBorder(mesh, map.ofVertex, absentTriangles(mesh));
    for (std::size_t p = 0; p < onBorder.size(); ++p) {
        if (onBorder[p] >= 0) {
            apexes[p] = mesh.position(onBorder[p]);
        }
    }
    return apexes;
}

double volumeOf(const SurfaceMesh& mesh, const std::vector<Vec3>& points) {
    double sum = 0;
    std::optional<Vec3> o;  // a corner: about a far origin rounding would be all that is left
    for (const int t : livingTriangles(mesh)) {
        const auto& [a, b, c] = mesh.triangle(t);
        o = o.value_or(points[a]);
        sum += tetrahedronVolume(points[a] - *o, points[b] - *o, points[c] - *o);
    }
    return sum;
}

}  // namespace

std::string checkTwins(const SurfaceMesh& mesh) {
    std::string fault = checkCorners(mesh);
    forEachHalfEdge(mesh, [&](int h) {
        if (fault.empty()) {
            fault = checkTwinOf(mesh, h);
        }
    });
    return fault;
}

std::string checkUmbrellas(const SurfaceMesh& mesh) {
    std::string fault = checkCorners(mesh);
    if (!fault.empty()) {
        return fault;
    }
    const OutgoingLists lists = listOutgoing(mesh);
    for (int v = 0; v < mesh.vertexCount() && fault.empty(); ++v) {
        fault = checkUmbrellaOf(mesh, v, lists.first[v + 1] - lists.first[v]);
    }
    return fault;
}

std::string checkSimpleComplex(const SurfaceMesh& mesh) {
    std::string fault = checkCorners(mesh);
    if (!fault.empty()) {
        return fault;
    }
    const OutgoingLists lists = listOutgoing(mesh);
    std::vector<int> reachedFrom(mesh.vertexCount(), -1);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        reachedFrom[v] = v;
        for (int i = lists.first[v]; i < lists.first[v + 1]; ++i) {
            const int target = mesh.target(lists.halfEdges[i]);
            if (target == v) {
                return edgeName(mesh, lists.halfEdges[i]) + " starts and ends at one vertex";
            }
            if (reachedFrom[target] == v) {
                return "two edges run between " + vertexName(v) + " and " + vertexName(target);
            }
            reachedFrom[target] = v;
        }
    }
    return "";
}

std::string checkFinite(const SurfaceMesh& mesh) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (!isFinite(mesh, v)) {
            return vertexName(v) + " has a coordinate or velocity that is not finite";
        }
    }
    return "";
}

std::string checkClosedManifold(const SurfaceMesh& mesh) {
    for (const auto check : {checkTwins, checkUmbrellas, checkSimpleComplex, checkFinite}) {
        std::string fault = check(mesh);
        if (!fault.empty()) {
            return fault;
        }
    }
    return "";
}

std::string checkClosedManifoldAround(const SurfaceMesh& mesh, std::span<const int> triangles) {
    std::string fault;
    for (const int t : triangles) {
        for (int h = 3 * t; h < 3 * t + 3 && mesh.alive(t) && fault.empty(); ++h) {
            fault = checkCornerOf(mesh, h);
        }
    }
    return fault;
}

std::vector<int> verticesOnBorder(const SurfaceMesh& mesh, const std::vector<int>& pieceOfVertex,
                                  std::span<const int> absent) {
    std::vector<int> found;
    for (const int t : absent) {
        for (const int v : mesh.triangle(t)) {
            const auto piece = static_cast<std::size_t>(pieceOfVertex[v]);
            if (piece >= found.size()) {
                found.resize(piece + 1, -1);
            }
            if (found[piece] < 0 && !hidden(mesh, v)) {
                found[piece] = v;
            }
        }
    }
    return found;
}

PieceMap findPieces(const SurfaceMesh& mesh) {
    const PieceLabels labels(mesh);
    PieceMap map;
    map.ofVertex = labels.ofVertex();
    for (const PieceContent& piece : labels.pieces()) {
        map.pieces.push_back(
            {piece.triangles, piece.vertices, 0, piece.restVolume, piece.restArea});
    }
    const std::vector<Vec3> apexes = volumeApexes(mesh, map);
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.present(t)) {
            const auto& [a, b, c] = mesh.triangle(t);
            const int piece = map.ofVertex[a];
            const Vec3& o = apexes[piece];
            map.pieces[piece].volume +=
                tetrahedronVolume(mesh.position(a) - o, mesh.position(b) - o, mesh.position(c) - o);
        }
    }
    return map;
}

double meshVolume(const SurfaceMesh& mesh) {
    return volumeOf(mesh, mesh.positions());
}

double meshRestVolume(const SurfaceMesh& mesh) {
    return volumeOf(mesh, mesh.restPositions());
}

Bounds meshBounds(const SurfaceMesh& mesh) {
    Bounds bounds;
    forEachHalfEdge(mesh, [&](int h) { bounds.add(mesh.position(mesh.origin(h))); });
    return bounds;
}

}  // namespace kerf
