#include "sim/body/body_model.h"

#include <cassert>

#include "sim/body/constraint_builder.h"
#include "sim/body/incidence.h"
#include "sim/body/ispc_builder.h"
#include "sim/body/piece_masses.h"
#include "sim/body/rest_geometry.h"

namespace kerf {

namespace {

constexpr double kDebrisVolume = 1e-4;  // of the uncut body
constexpr int kLeastSolidVertices = 4;

void measureUncutBody(BodyModel& model, const SurfaceMesh& mesh) {
    double area = 0;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        area += mesh.alive(t) ? restArea(mesh, t) : 0.0;
    }
    model.uncutRestVolume = meshRestVolume(mesh);
    assert(model.uncutRestVolume > 0 && area > 0);
    model.thickness = model.uncutRestVolume / area;
    model.edgeLength = meanRestEdgeLength(mesh);
}

void copyRestShape(BodyModel& model, const SurfaceMesh& mesh) {
    model.restPositions.reserve(mesh.restPositions().size());
    for (const Vec3& p : mesh.restPositions()) {
        model.restPositions.push_back(p.cast<float>());
    }
}

PieceModel pieceModel(const Piece& piece, double uncutRestVolume) {
    PieceModel result;
    result.triangleCount = static_cast<std::uint32_t>(piece.triangles);
    result.vertexCount = static_cast<std::uint32_t>(piece.vertices);
    result.restVolume = piece.restVolume;
    result.restArea = piece.restArea;
    result.holdsVolume = piece.restVolume >= kDebrisVolume * uncutRestVolume &&
                         piece.vertices >= kLeastSolidVertices;
    return result;
}

void listPieces(BodyModel& model, const SurfaceMesh& mesh) {
    PieceMap map = findPieces(mesh);
    std::uint32_t first = 0;
    for (const Piece& piece : map.pieces) {
        model.pieces.push_back(pieceModel(piece, model.uncutRestVolume));
        model.pieces.back().firstTriangle = first;
        first += model.pieces.back().triangleCount;
    }
    model.pieceOfVertex = std::move(map.ofVertex);
}

/// Living triangles, piece after piece, inside a piece by mesh slot.
void orderTriangles(BodyModel& model, const SurfaceMesh& mesh) {
    std::vector<std::uint32_t> cursor;
    for (const PieceModel& piece : model.pieces) {
        cursor.push_back(piece.firstTriangle);
    }
    model.triangles.resize(mesh.aliveTriangles());
    model.meshTriangle.resize(mesh.aliveTriangles());
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (!mesh.alive(t)) {
            continue;
        }
        const Triangle& corners = mesh.triangle(t);
        const auto piece = static_cast<std::uint32_t>(model.pieceOfVertex[corners[0]]);
        const std::uint32_t tag = static_cast<std::uint32_t>(mesh.kind(t)) | piece << 8;
        const std::uint32_t slot = cursor[piece]++;
        model.triangles[slot] = {static_cast<std::uint32_t>(corners[0]),
                                 static_cast<std::uint32_t>(corners[1]),
                                 static_cast<std::uint32_t>(corners[2]), tag};
        model.meshTriangle[slot] = t;
    }
}

/// All but the ISPCs and the incidences.
void buildShell(BodyModel& model, const SurfaceMesh& mesh, const std::vector<double>& areas) {
    copyRestShape(model, mesh);
    listPieces(model, mesh);
    orderTriangles(model, mesh);
    model.unitMass =
        buildUnitMasses(model.pieces, model.pieceOfVertex, areas, model.uncutRestVolume);
    model.edges = buildEdges(mesh, model.thickness);
    model.bends = buildBends(mesh, model.thickness);
}

void buildIncidences(BodyModel& model) {
    const std::size_t n = model.restPositions.size();
    model.triangleIncidence = buildIncidence(model.triangles, n);
    model.edgeIncidence = buildIncidence(model.edges, n);
    model.bendIncidence = buildIncidence(model.bends, n);
    model.ispcIncidence = buildIncidence(model.ispcs, n);
}

void appendIspc(BodyModel& model, const CastIspc& ispc) {
    model.ispcs.push_back(ispc.constraint);
    model.ispcMeshTriangle.push_back(ispc.meshTriangle);
}

/// What a cut touched.
struct Touched {
    std::vector<char> triangles;  ///< by mesh slot: removed, added or changed
    std::vector<char> vertices;   ///< corners of added and changed triangles
};

Touched findTouched(const SurfaceMesh& mesh, const CutDelta& delta) {
    Touched touched{std::vector<char>(mesh.triangleSlots(), 0),
                    std::vector<char>(mesh.vertexCount(), 0)};
    for (const auto* list :
         {&delta.removedTriangles, &delta.addedTriangles, &delta.changedTriangles}) {
        for (const int t : *list) {
            touched.triangles[t] = 1;
            if (mesh.alive(t)) {
                for (const int v : mesh.triangle(t)) {
                    touched.vertices[v] = 1;
                }
            }
        }
    }
    return touched;
}

/// Walls that are new or lie elsewhere.
std::vector<int> newWalls(const SurfaceMesh& mesh, const CutDelta& delta) {
    std::vector<int> walls;
    for (const auto* list : {&delta.addedTriangles, &delta.changedTriangles}) {
        for (const int t : *list) {
            if (mesh.alive(t) && mesh.kind(t) == SurfaceKind::wall) {
                walls.push_back(t);
            }
        }
    }
    return walls;
}

/// Which ISPCs of the old model still stand in the new one.
class IspcKeeper {
  public:
    IspcKeeper(const SurfaceMesh& mesh, const CutDelta& delta,
               const std::vector<int>& pieceOfVertex)
        : mesh_(mesh),
          pieceOfVertex_(pieceOfVertex),
          touched_(findTouched(mesh, delta)),
          walls_(mesh, newWalls(mesh, delta)) {}

    bool touchedVertex(int v) const { return touched_.vertices[v] != 0; }

    bool stands(const shared::IspcConstraint& ispc, int meshTriangle) const {
        const int v = static_cast<int>(ispc.vertex);
        if (touchedVertex(v) || touched_.triangles[meshTriangle] || !mesh_.alive(meshTriangle)) {
            return false;
        }
        return pieceOfVertex_[v] >= 0 && pieceOfVertex_[v] == pieceOfVertex_[ispc.t0] &&
               !walls_.crosses(mesh_.restPosition(v), restEnd(mesh_, ispc));
    }

  private:
    const SurfaceMesh& mesh_;
    const std::vector<int>& pieceOfVertex_;
    Touched touched_;
    RayTree walls_;
};

enum class IspcFate : char { none, kept, recast };

/// Index of the old ISPC of each vertex, -1 for none.
std::vector<int> indexByVertex(const BodyModel& before, int vertexCount) {
    std::vector<int> index(vertexCount, -1);
    for (std::size_t i = 0; i < before.ispcs.size(); ++i) {
        index[before.ispcs[i].vertex] = static_cast<int>(i);
    }
    return index;
}

IspcFate fateOf(const BodyModel& before, const IspcKeeper& keeper, int vertex, int oldIndex) {
    if (oldIndex < 0) {
        return keeper.touchedVertex(vertex) ? IspcFate::recast : IspcFate::none;
    }
    return keeper.stands(before.ispcs[oldIndex], before.ispcMeshTriangle[oldIndex])
               ? IspcFate::kept
               : IspcFate::recast;
}

void castAllIspcs(BodyModel& model, const SurfaceMesh& mesh, const std::vector<double>& areas) {
    const IspcCaster caster(mesh, model.pieceOfVertex, model.edgeLength);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (const std::optional<CastIspc> ispc = caster.cast(v, areas[v])) {
            appendIspc(model, *ispc);
        }
    }
}

void updateIspcs(BodyModel& model, const BodyModel& before, const SurfaceMesh& mesh,
                 const CutDelta& delta, const std::vector<double>& areas) {
    const IspcKeeper keeper(mesh, delta, model.pieceOfVertex);
    const IspcCaster caster(mesh, model.pieceOfVertex, model.edgeLength);
    const std::vector<int> oldIndex = indexByVertex(before, mesh.vertexCount());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const IspcFate fate = fateOf(before, keeper, v, oldIndex[v]);
        if (fate == IspcFate::kept) {
            appendIspc(model, {before.ispcs[oldIndex[v]], before.ispcMeshTriangle[oldIndex[v]]});
        } else if (fate == IspcFate::recast) {
            if (const std::optional<CastIspc> ispc = caster.cast(v, areas[v])) {
                appendIspc(model, *ispc);
            }
        }
    }
}

}  // namespace

BodyModel buildBodyModel(const SurfaceMesh& mesh) {
    const std::vector<double> areas = restVertexAreas(mesh);
    BodyModel model;
    measureUncutBody(model, mesh);
    buildShell(model, mesh, areas);
    castAllIspcs(model, mesh, areas);
    buildIncidences(model);
    return model;
}

BodyModel updateBodyModel(const BodyModel& before, const SurfaceMesh& mesh, const CutDelta& delta) {
    const std::vector<double> areas = restVertexAreas(mesh);
    BodyModel model;
    model.thickness = before.thickness;
    model.edgeLength = before.edgeLength;
    model.uncutRestVolume = before.uncutRestVolume;
    buildShell(model, mesh, areas);
    updateIspcs(model, before, mesh, delta, areas);
    buildIncidences(model);
    return model;
}

}  // namespace kerf
