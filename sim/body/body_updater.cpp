#include "sim/body/body_updater.h"

#include <cassert>

#include "sim/body/constraint_lists.h"
#include "sim/body/rest_geometry.h"
#include "sim/body/surface_tag.h"
#include "sim/cut/cut_change.h"

namespace kerf {

namespace {

constexpr double kDebrisVolume = 1e-4;  // of the uncut body
constexpr std::uint32_t kLeastSolidVertices = 4;

std::uint32_t index32(int i) {
    return static_cast<std::uint32_t>(i);
}

/// Adds those whose number of triangles or constraints changed.
void addListed(BodyChange& change) {
    const auto add = [&](const std::vector<std::uint32_t>& listed) {
        change.vertices.insert(change.vertices.end(), listed.begin(), listed.end());
    };
    add(change.triangles.vertices);
    for (const ListChange& constraints : change.constraints) {
        add(constraints.vertices);
    }
    sortUnique(change.vertices);
}

Bounds boxOfUsedVertices(const BodyModel& model) {
    Bounds box;
    for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
        if (model.pieceOfVertex[v] >= 0) {
            box.add(model.restPositions[v].cast<double>());
        }
    }
    return box;
}

}  // namespace

BodyModel buildBodyModel(const SurfaceMesh& mesh, std::span<const int> firstVertices) {
    return BodyUpdater(mesh, firstVertices).model();
}

BodyUpdater::BodyUpdater(const SurfaceMesh& mesh, std::span<const int> firstVertices)
    : mesh_(mesh), labels_(mesh) {
    buildShell(firstVertices);
    ispcs_.emplace(mesh, model_);
    listConstraints();
}

void BodyUpdater::listConstraints() {
    forEachType(model_, [this](auto row, const auto& constraints) {
        Incidence& incidence = model_.incidences[row.kType];
        incidence = buildIncidence(constraints, model_.restPositions.size());
        constraintRooms_[row.kType] = IncidenceRooms(incidence);
    });
}

/// All but the ISPCs.
void BodyUpdater::buildShell(std::span<const int> firstVertices) {
    tellMembers(firstVertices);
    measureUncutBody();
    absent_ = absentTriangles(mesh_);
    for (int v = 0; v < mesh_.vertexCount(); ++v) {
        model_.pieceOfVertex.push_back(presentPieceOf(v));
        model_.restPositions.push_back(mesh_.restPosition(v).cast<float>());
    }
    model_.diagonal = boxOfUsedVertices(model_).diagonal();
    skinNormals_ = SkinNormals(mesh_);
    model_.cutSkinNormals.assign(model_.restPositions.size(), Vec3f::Zero());
    model_.vertexAreas = restVertexAreas(mesh_);
    areas_.resize(labels_.pieces().size());
    for (std::size_t v = 0; v < model_.vertexAreas.size(); ++v) {
        if (const int piece = model_.pieceOfVertex[v]; piece >= 0) {
            areas_[piece].add(model_.vertexAreas[v]);
        }
    }
    updateMasses();
    buildTriangles();
    buildEdgesAndBends();
}

/// A piece is of one model: nothing joins two.
void BodyUpdater::tellMembers(std::span<const int> firstVertices) {
    model_.members.resize(std::max<std::size_t>(firstVertices.size(), 1));
    memberOfPiece_.resize(labels_.pieces().size());
    int member = 0;
    for (int v = 0; v < mesh_.vertexCount(); ++v) {
        while (member + 1 < static_cast<int>(firstVertices.size()) &&
               firstVertices[member + 1] <= v) {
            ++member;
        }
        if (const int piece = labels_.ofVertex()[v]; piece >= 0) {
            memberOfPiece_[piece] = member;
        }
    }
}

void BodyUpdater::measureUncutBody() {
    std::vector<double> areas(model_.members.size());
    for (std::size_t p = 0; p < labels_.pieces().size(); ++p) {
        const PieceContent& piece = labels_.pieces()[p];
        areas[memberOfPiece_[p]] += piece.restArea;
        model_.members[memberOfPiece_[p]].restVolume += piece.restVolume;
    }
    for (std::size_t m = 0; m < areas.size(); ++m) {
        BodyMember& member = model_.members[m];
        assert(member.restVolume > 0 && areas[m] > 0);
        member.thickness = member.restVolume / areas[m];
        model_.uncutRestVolume += member.restVolume;
    }
    model_.edgeLength = meanRestEdgeLength(mesh_);
}

void BodyUpdater::buildTriangles() {
    slotOfTriangle_.assign(mesh_.triangleSlots(), -1);
    for (int t = 0; t < mesh_.triangleSlots(); ++t) {
        if (mesh_.present(t)) {
            slotOfTriangle_[t] = static_cast<int>(model_.triangles.size());
            model_.triangles.push_back(taggedTriangle(t));
            model_.meshTriangle.push_back(t);
        }
    }
    model_.triangleIncidence = buildIncidence(model_.triangles, model_.restPositions.size());
    triangleRooms_ = IncidenceRooms(model_.triangleIncidence);
    std::vector<std::uint32_t> all(model_.restPositions.size());
    std::iota(all.begin(), all.end(), 0u);
    neighbourRooms_.resize(model_.neighbours, all.size());
    updateNeighbours(all);
}

void BodyUpdater::buildEdgesAndBends() {
    slotsOfEdge_.assign(3 * static_cast<std::size_t>(mesh_.triangleSlots()), {});
    forEachEdge(mesh_, [&](int h) {
        const int g = mesh_.twin(h);
        slotsOfEdge_[h].edge = slotsOfEdge_[g].edge = static_cast<int>(model_.edges.size());
        model_.edges.push_back(edgeConstraint(mesh_, h, thicknessAt(h), skinAt(h)));
        halfEdgesOfEdge_.emplace_back(h, g);
        if (const auto bend = bendConstraint(mesh_, h, thicknessAt(h))) {
            slotsOfEdge_[h].bend = slotsOfEdge_[g].bend = static_cast<int>(model_.bends.size());
            model_.bends.push_back(*bend);
            halfEdgesOfBend_.emplace_back(h, g);
        }
    });
}

const BodyMember& BodyUpdater::memberAt(int halfEdge) const {
    return model_.members[memberOfPiece_[labels_.ofVertex()[mesh_.target(halfEdge)]]];
}

double BodyUpdater::thicknessAt(int halfEdge) const {
    return memberAt(halfEdge).thickness;
}

double BodyUpdater::skinAt(int halfEdge) const {
    return memberAt(halfEdge).skin;
}

/// The skin has become another one.
void BodyUpdater::renewEdges() {
    for (std::size_t i = 0; i < model_.edges.size(); ++i) {
        const int h = halfEdgesOfEdge_[i].first;
        model_.edges[i].geometry = edgeConstraint(mesh_, h, thicknessAt(h), skinAt(h)).geometry;
    }
}

/// -1 where no triangle around the vertex is present.
int BodyUpdater::presentPieceOf(int vertex) const {
    return hidden(mesh_, vertex) ? -1 : labels_.ofVertex()[vertex];
}

std::vector<int> BodyUpdater::hiddenVertices() const {
    std::vector<int> vertices;
    for (const int t : absent_) {
        std::ranges::copy_if(mesh_.triangle(t), std::back_inserter(vertices),
                             [this](int v) { return hidden(mesh_, v); });
    }
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

std::array<std::uint32_t, 4> BodyUpdater::taggedTriangle(int triangle) const {
    const Triangle& corners = mesh_.triangle(triangle);
    return {index32(corners[0]), index32(corners[1]), index32(corners[2]),
            surfaceTag(mesh_, triangle) | index32(model_.pieceOfVertex[corners[0]]) << 8};
}

BodyChange BodyUpdater::update(const CutDelta& delta) {
    const std::vector<int> changed = changedTriangles(delta);
    BodyChange change;
    change.pieces = labels_.update(mesh_, changed);
    followMembers(change.pieces.source);
    pausePoint();
    growVertices();
    followAbsent(changed);
    pausePoint();
    updateAreas(delta, changed, change);
    pausePoint();
    change.neighbourLists = change.vertices;
    updateMasses();
    updateSkinNormals(delta, changed, change.vertices);
    updateTriangles(changed, change);
    pausePoint();
    updateNeighbours(change.neighbourLists);
    pausePoint();
    updateShell(changed, change);
    pausePoint();
    updateIspcs(changed, change);
    pausePoint();
    addListed(change);
    return change;
}

/// A piece stays with the model that it came off. One of new vertices alone is of the model whose
/// old vertices are next to it.
void BodyUpdater::followMembers(std::span<const int> sources) {
    if (model_.members.size() == 1) {
        memberOfPiece_.assign(sources.size(), 0);
        return;
    }
    std::vector<int> now;
    now.reserve(sources.size());
    for (std::size_t p = 0; p < sources.size(); ++p) {
        const int source = sources[p] >= 0 ? sources[p] : nearestOldPiece(static_cast<int>(p));
        now.push_back(memberOfPiece_[source]);
    }
    memberOfPiece_ = std::move(now);
}

/// Before the vertices follow.
int BodyUpdater::nearestOldPiece(int piece) const {
    const auto vertex = std::ranges::find(labels_.ofVertex(), piece) - labels_.ofVertex().begin();
    const Vec3f at = mesh_.restPosition(static_cast<int>(vertex)).cast<float>();
    int nearest = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t v = 0; v < model_.restPositions.size(); ++v) {
        const float distance = (model_.restPositions[v] - at).squaredNorm();
        if (model_.pieceOfVertex[v] >= 0 && distance < least) {
            least = distance;
            nearest = model_.pieceOfVertex[v];
        }
    }
    return nearest;
}

bool BodyUpdater::setMaterials(std::span<const MemberMaterial> materials) {
    assert(materials.size() == model_.members.size());
    bool differ = false;
    bool skinDiffers = false;
    for (std::size_t m = 0; m < materials.size(); ++m) {
        BodyMember& member = model_.members[m];
        const auto& [modulus, density, skin] = materials[m];
        differ |= member.modulus != modulus || member.density != density;
        skinDiffers |= member.skin != skin;
        member.modulus = modulus;
        member.density = density;
        member.skin = skin;
    }
    if (differ) {
        updateMasses();
    }
    if (skinDiffers) {
        renewEdges();
    }
    return differ || skinDiffers;
}

void BodyUpdater::growVertices() {
    const std::size_t n = mesh_.vertexCount();
    for (std::size_t v = model_.restPositions.size(); v < n; ++v) {
        model_.restPositions.push_back(mesh_.restPosition(static_cast<int>(v)).cast<float>());
    }
    model_.cutSkinNormals.resize(n, Vec3f::Zero());
    model_.vertexAreas.resize(n, 0.0);
    model_.pieceOfVertex.resize(n, -1);
    triangleRooms_.resize(model_.triangleIncidence, n);
    neighbourRooms_.resize(model_.neighbours, n);
    for (std::uint32_t type = 0; type < kConstraintTypes; ++type) {
        constraintRooms_[type].resize(model_.incidences[type], n);
    }
}

double BodyUpdater::vertexArea(int vertex) const {
    double sum = 0;
    mesh_.forEachOutgoing(
        vertex, [&](int h) { sum += mesh_.absent(h / 3) ? 0.0 : restArea(mesh_, h / 3) / 3; });
    return sum;
}

/// Areas, pieces and rest positions of the vertices, all new ones among them; what
/// they are leaves the sums of their old piece, what they become enters those of the new one.
void BodyUpdater::updateAreas(const CutDelta& delta, std::span<const int> changed,
                              BodyChange& change) {
    for (int v = delta.firstNewVertex; v < mesh_.vertexCount(); ++v) {
        change.vertices.push_back(index32(v));
    }
    for (const int t : changed) {
        if (mesh_.alive(t)) {
            for (const int v : mesh_.triangle(t)) {
                change.vertices.push_back(index32(v));
            }
        }
    }
    for (const LabelMove& move : change.pieces.moves) {
        change.vertices.push_back(index32(move.vertex));
    }
    sortUnique(change.vertices);
    for (const std::uint32_t v : change.vertices) {
        if (const int piece = model_.pieceOfVertex[v]; piece >= 0) {
            areas_[piece].remove(model_.vertexAreas[v]);
        }
    }
    areas_.resize(labels_.pieces().size());
    for (const std::uint32_t v : change.vertices) {
        model_.restPositions[v] = mesh_.restPosition(static_cast<int>(v)).cast<float>();
        model_.vertexAreas[v] = vertexArea(static_cast<int>(v));
        model_.pieceOfVertex[v] = presentPieceOf(static_cast<int>(v));
        if (const int piece = model_.pieceOfVertex[v]; piece >= 0) {
            areas_[piece].add(model_.vertexAreas[v]);
        }
    }
}

/// Before the triangles follow: what the skin was tells what its new vertices have.
void BodyUpdater::updateSkinNormals(const CutDelta& delta, std::span<const int> changed,
                                    std::span<const std::uint32_t> vertices) {
    std::vector<Triangle> old;
    for (const int t : changed) {
        const int slot = t < static_cast<int>(slotOfTriangle_.size()) ? slotOfTriangle_[t] : -1;
        if (slot >= 0 && (model_.triangles[slot][3] & 1u) == 0) {
            const auto& [a, b, c, tag] = model_.triangles[slot];
            old.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
        }
    }
    skinNormals_.follow(mesh_, delta.firstNewVertex, old);
    for (const std::uint32_t v : vertices) {
        model_.cutSkinNormals[v] = skinNormals_.ofCut(mesh_, static_cast<int>(v)).cast<float>();
    }
}

/// Triangles that a step removed, or that are present now, leave the list.
void BodyUpdater::followAbsent(std::span<const int> changed) {
    std::erase_if(absent_, [this](int t) { return !mesh_.alive(t) || !mesh_.absent(t); });
    for (const int t : changed) {
        const auto place = std::ranges::lower_bound(absent_, t);
        const bool known = place != absent_.end() && *place == t;
        if (mesh_.alive(t) && mesh_.absent(t) && !known) {
            absent_.insert(place, t);
        }
    }
}

void BodyUpdater::updateMasses() {
    std::vector<std::uint32_t> absentOf(labels_.pieces().size(), 0);
    for (const int t : absent_) {
        ++absentOf[labels_.ofVertex()[mesh_.triangle(t)[0]]];
    }
    const std::vector<int> rimVertices = verticesOnBorder(mesh_, labels_.ofVertex(), absent_);
    model_.pieces.clear();
    for (std::size_t p = 0; p < labels_.pieces().size(); ++p) {
        const PieceContent& content = labels_.pieces()[p];
        PieceModel piece;
        piece.member = memberOfPiece_[p];
        const BodyMember& member = model_.members[piece.member];
        piece.triangleCount = index32(content.triangles) - absentOf[p];
        piece.vertexCount = index32(areas_[p].count());
        piece.open = absentOf[p] > 0;
        piece.rimVertex = p < rimVertices.size() ? rimVertices[p] : -1;
        piece.restVolume = content.restVolume;
        piece.restArea = content.restArea;
        piece.holdsVolume = !piece.open &&
                            content.restVolume >= kDebrisVolume * member.restVolume &&
                            piece.vertexCount >= kLeastSolidVertices;
        areas_[p].setMasses(piece, member.restVolume);
        piece.massPerArea *= member.density;
        model_.pieces.push_back(piece);
    }
}

void BodyUpdater::updateTriangles(std::span<const int> changed, BodyChange& change) {
    RecordEditor triangles(model_.triangles, model_.triangleIncidence, triangleRooms_);
    slotOfTriangle_.resize(mesh_.triangleSlots(), -1);
    for (const int t : changed) {
        if (const int slot = std::exchange(slotOfTriangle_[t], -1); slot >= 0) {
            triangles.remove(slot);
        }
    }
    for (const int t : changed) {
        if (mesh_.present(t)) {
            const int slot = triangles.add(taggedTriangle(t));
            model_.meshTriangle.resize(model_.triangles.size(), -1);
            model_.meshTriangle[slot] = t;
            slotOfTriangle_[t] = slot;
        }
    }
    for (const LabelMove& move : change.pieces.moves) {
        mesh_.forEachOutgoing(move.vertex, [&](int h) {
            if (h % 3 == 0 && !mesh_.absent(h / 3)) {
                triangles.rewrite(slotOfTriangle_[h / 3])[3] = taggedTriangle(h / 3)[3];
            }
        });
    }
    updateRims(changed, triangles);
    triangles.close([&](int from, int to) {
        model_.meshTriangle[to] = model_.meshTriangle[from];
        slotOfTriangle_[model_.meshTriangle[to]] = to;
    });
    model_.meshTriangle.resize(model_.triangles.size());
    change.triangles = triangles.takeChange();
}

/// A triangle that stays as it is may get a new neighbour, and with it another rim.
void BodyUpdater::updateRims(std::span<const int> changed,
                             RecordEditor<std::array<std::uint32_t, 4>>& triangles) {
    for (const int t : changed) {
        for (int h = 3 * t; h < 3 * t + 3 && mesh_.alive(t); ++h) {
            const int neighbour = mesh_.twin(h) / 3;
            const std::uint32_t tag = taggedTriangle(neighbour)[3];
            const int slot = slotOfTriangle_[neighbour];
            if (slot >= 0 && model_.triangles[slot][3] != tag) {
                triangles.rewrite(slot)[3] = tag;
            }
        }
    }
}

/// The order around a vertex is that of its umbrella.
void BodyUpdater::updateNeighbours(std::span<const std::uint32_t> vertices) {
    std::vector<std::uint32_t> around;
    for (const std::uint32_t v : vertices) {
        around.clear();
        mesh_.forEachOutgoing(static_cast<int>(v), [&](int h) {
            const bool afterGap = mesh_.absent(mesh_.twin(h) / 3);
            around.push_back(index32(mesh_.target(h)) | (afterGap ? shared::kAfterGap : 0u));
        });
        neighbourRooms_.assign(model_.neighbours, v, around);
    }
}

/// Edges and bends. All that a changed triangle has a share in is made anew.
void BodyUpdater::updateShell(std::span<const int> changed, BodyChange& change) {
    RecordEditor edges = edit(model_.edges, shared::kStretch);
    RecordEditor bends = edit(model_.bends, shared::kBend);
    slotsOfEdge_.resize(3 * static_cast<std::size_t>(mesh_.triangleSlots()));
    const auto drop = [&](int halfEdge) {
        if (const int edge = slotsOfEdge_[halfEdge].edge; edge >= 0) {
            const auto [h, g] = halfEdgesOfEdge_[edge];
            edges.remove(edge);
            if (const int bend = slotsOfEdge_[h].bend; bend >= 0) {
                bends.remove(bend);
            }
            slotsOfEdge_[h] = slotsOfEdge_[g] = {};
        }
    };
    for (const int t : changed) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            drop(h);
            if (mesh_.alive(t)) {
                drop(mesh_.twin(h));
            }
        }
    }
    for (const int t : changed) {
        for (int h = 3 * t; h < 3 * t + 3 && mesh_.alive(t); ++h) {
            if (slotsOfEdge_[h].edge < 0 && isPresentEdge(mesh_, h)) {
                addEdge(std::min(h, mesh_.twin(h)), edges, bends);
            }
        }
    }
    edges.close([&](int from, int to) {
        const auto [h, g] = halfEdgesOfEdge_[to] = halfEdgesOfEdge_[from];
        slotsOfEdge_[h].edge = slotsOfEdge_[g].edge = to;
    });
    bends.close([&](int from, int to) {
        const auto [h, g] = halfEdgesOfBend_[to] = halfEdgesOfBend_[from];
        slotsOfEdge_[h].bend = slotsOfEdge_[g].bend = to;
    });
    halfEdgesOfEdge_.resize(model_.edges.size());
    halfEdgesOfBend_.resize(model_.bends.size());
    change.constraints[shared::kStretch] = edges.takeChange();
    change.constraints[shared::kBend] = bends.takeChange();
}

void BodyUpdater::updateIspcs(std::span<const int> changed, BodyChange& change) {
    RecordEditor ispcs = edit(model_.ispcs, shared::kIspc);
    ispcs_->update(model_, changed, change.pieces, ispcs);
    change.constraints[shared::kIspc] = ispcs.takeChange();
}

BodyChange BodyUpdater::castIspcs(IspcRays rays) {
    BodyChange change;
    change.pieces.source.resize(model_.pieces.size());
    std::iota(change.pieces.source.begin(), change.pieces.source.end(), 0);
    RecordEditor ispcs = edit(model_.ispcs, shared::kIspc);
    ispcs_->castAnew(model_, rays, ispcs);
    change.constraints[shared::kIspc] = ispcs.takeChange();
    addListed(change);
    return change;
}

void BodyUpdater::addEdge(int h, RecordEditor<EdgeConstraint>& edges,
                          RecordEditor<BendConstraint>& bends) {
    const int g = mesh_.twin(h);
    const double thickness = thicknessAt(h);
    const int edge = edges.add(edgeConstraint(mesh_, h, thickness, skinAt(h)));
    halfEdgesOfEdge_.resize(model_.edges.size());
    halfEdgesOfEdge_[edge] = {h, g};
    slotsOfEdge_[h].edge = slotsOfEdge_[g].edge = edge;
    if (const auto constraint = bendConstraint(mesh_, h, thickness)) {
        const int bend = bends.add(*constraint);
        halfEdgesOfBend_.resize(model_.bends.size());
        halfEdgesOfBend_[bend] = {h, g};
        slotsOfEdge_[h].bend = slotsOfEdge_[g].bend = bend;
    }
}

}  // namespace kerf
