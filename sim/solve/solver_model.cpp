#include "sim/solve/solver_model.h"

#include <array>

#include "sim/body/incidence.h"
#include "sim/solve/float_vectors.h"

namespace kerf {

namespace {

using shared::uint;

static_assert(sizeof(shared::BendRecord) == 32);
static_assert(sizeof(shared::BendRange) == 16);
static_assert(sizeof(shared::IspcShare) == 8);
static_assert(sizeof(shared::IspcConstraint) == 32);
static_assert(sizeof(shared::VertexLinks) == 16);
static_assert(sizeof(shared::IncidenceRange) == 8);
static_assert(sizeof(shared::Spoke) == 16);

shared::VertexLinks linksOf(const BodyModel& model, std::size_t v) {
    const int piece = model.pieceOfVertex[v];
    return {valence(model.edgeIncidence, v), valence(model.bendIncidence, v),
            valence(model.ispcIncidence, v),
            piece < 0 ? shared::kNoPiece : static_cast<uint>(piece)};
}

std::vector<shared::VertexLinks> vertexLinks(const BodyModel& model) {
    std::vector<shared::VertexLinks> links(model.restPositions.size());
    for (std::size_t v = 0; v < links.size(); ++v) {
        links[v] = linksOf(model, v);
    }
    return links;
}

}  // namespace

void IncidenceBuffers::assign(const Incidence& incidence) {
    ranges.assign(incidence.ranges);
    entries.assign(incidence.entries);
}

void IncidenceBuffers::update(const Incidence& incidence, const std::vector<uint>& vertices,
                              Scatter& scatter) {
    scatter.write<IncidenceRange>(ranges, incidence.ranges, vertices);
    scatter.write<uint>(entries, incidence.entries, placesOf(incidence, vertices));
}

void SolverModel::takeVertices(const BodyModel& model) {
    areas.assign(model.vertexAreas.begin(), model.vertexAreas.end());
    pieceOf = model.pieceOfVertex;
    diagonal = boundsOf(model.restPositions).diagonal();
}

void SolverModel::uploadRestShape(const BodyModel& model) {
    restPositions.assign(packed(model.restPositions));
    cutSkinNormals.assign(packed(model.cutSkinNormals));
    links.assign(vertexLinks(model));
    areaBuffer.assign(areas);
}

void SolverModel::uploadSpokes(const BodyModel& model) {
    edgeRanges.assign(model.edgeIncidence.ranges);
    spokes.assign(allSpokes(model));
}

void SolverModel::uploadBendLists(const BodyModel& model) {
    bendLists_.assign(model);
    bendRanges.assign(bendLists_.ranges);
    bendEntries.assign(bendLists_.entries);
}

void SolverModel::uploadIspcShares(const BodyModel& model) {
    ispcRanges.assign(model.ispcIncidence.ranges);
    ispcShares.assign(allIspcShares(model));
}

void SolverModel::uploadTriangleLists(const BodyModel& model) {
    triangleIncidence.assign(model.triangleIncidence);
    neighbours.assign(model.neighbours);
}

void SolverModel::update(const BodyModel& model, const BodyChange& change, Scatter& scatter) {
    updateVertices(model, change, scatter);
    scatter.write<std::array<uint, 4>>(triangles, model.triangles, change.triangles);
    updateSpokes(model, change, scatter);
    updateBends(model, change, scatter);
    updateIspcs(model, change, scatter);
    triangleIncidence.update(model.triangleIncidence, change.triangleLists, scatter);
    neighbours.update(model.neighbours, change.neighbourLists, scatter);
}

void SolverModel::updateVertices(const BodyModel& model, const BodyChange& change,
                                 Scatter& scatter) {
    const std::size_t n = model.restPositions.size();
    areas.resize(n);
    pieceOf.resize(n, -1);
    for (const uint v : change.vertices) {
        areas[v] = static_cast<float>(model.vertexAreas[v]);
        pieceOf[v] = model.pieceOfVertex[v];
    }
    const auto fill = Scatter::Gaps::fill;
    scatter.write<shared::VertexLinks>(links, n, change.vertices, fill,
                                       [&](uint v) { return linksOf(model, v); });
    scatter.write<shared::vec4>(restPositions, n, change.vertices, fill,
                                [&](uint v) { return packed(model.restPositions[v], 0.0f); });
    scatter.write<shared::vec4>(cutSkinNormals, n, change.vertices, fill,
                                [&](uint v) { return packed(model.cutSkinNormals[v], 0.0f); });
    scatter.write<float>(areaBuffer, areas, change.vertices);
}

void SolverModel::updateSpokes(const BodyModel& model, const BodyChange& change, Scatter& scatter) {
    scatter.write<IncidenceRange>(edgeRanges, model.edgeIncidence.ranges, change.edgeLists);
    scatter.write<shared::Spoke>(spokes, model.edgeIncidence.entries.size(),
                                 changedSpokes(model, change), Scatter::Gaps::keep,
                                 [&](uint place) { return spokeAt(model, place); });
}

void SolverModel::updateBends(const BodyModel& model, const BodyChange& change, Scatter& scatter) {
    scatter.write<shared::BendRecord>(bends, model.bends.size(), change.bends, Scatter::Gaps::fill,
                                      [&](uint b) { return bendRecord(model.bends[b]); });
    bendLists_.update(model, change.bendLists);
    scatter.write<shared::BendRange>(bendRanges, bendLists_.ranges, change.bendLists);
    scatter.write<uint>(bendEntries, bendLists_.entries,
                        placesOf(model.bendIncidence, change.bendLists));
}

void SolverModel::updateIspcs(const BodyModel& model, const BodyChange& change, Scatter& scatter) {
    scatter.write<shared::IspcConstraint>(ispcs, model.ispcs, change.ispcs);
    scatter.write<IncidenceRange>(ispcRanges, model.ispcIncidence.ranges, change.ispcLists);
    scatter.write<shared::IspcShare>(ispcShares, model.ispcIncidence.entries.size(),
                                     changedIspcShares(model, change), Scatter::Gaps::keep,
                                     [&](uint place) { return ispcShareAt(model, place); });
}

}  // namespace kerf
