#include "sim/body/ispc_set.h"

#include "sim/base/containers.h"
#include "sim/base/math.h"

namespace kerf {

namespace {

constexpr int kMostPerAxis = 32;
constexpr double kPad = 1e-6;  // of a cell: a step along a segment may round past a corner

std::vector<int> newWalls(const SurfaceMesh& mesh, std::span<const int> changed) {
    std::vector<int> walls;
    for (const int t : changed) {
        if (mesh.alive(t) && mesh.kind(t) == SurfaceKind::wall) {
            walls.push_back(t);
        }
    }
    return walls;
}

}  // namespace

SegmentGrid::SegmentGrid(const Bounds& box, int count) : box_(box) {
    perAxis_ = std::clamp(static_cast<int>(std::cbrt(count) / 2), 2, kMostPerAxis);
    cellSize_ = (box.high - box.low).cwiseMax(1e-30) / perAxis_;
    cells_.resize(static_cast<std::size_t>(perAxis_) * perAxis_ * perAxis_);
    entriesExpected_ = 2L * perAxis_ * std::max(count, 100);
}

SegmentGrid::Cell SegmentGrid::cellOf(const Vec3& p) const {
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis) {
        const double place = (p[axis] - box_.low[axis]) / cellSize_[axis];
        cell[axis] = static_cast<int>(std::clamp(std::floor(place), 0.0, perAxis_ - 1.0));
    }
    return cell;
}

// From cell to cell through the nearest side (Amanatides and Woo 1987).
void SegmentGrid::add(int id, const Vec3& from, const Vec3& to) {
    Cell cell = cellOf(from);
    const Cell last = cellOf(to);
    const Vec3 along = to - from;
    cells_[indexOf(cell)].push_back(id);
    ++entries_;
    for (int steps = 0; cell != last && steps < 3 * perAxis_; ++steps) {
        int axis = -1;
        double nearest = 1e300;
        for (int k = 0; k < 3; ++k) {
            if (cell[k] == last[k]) {
                continue;
            }
            const double side =
                box_.low[k] + cellSize_[k] * (cell[k] + (last[k] > cell[k] ? 1 : 0));
            const double reached = along[k] != 0 ? (side - from[k]) / along[k] : 0.0;
            if (axis < 0 || reached < nearest) {
                nearest = reached;
                axis = k;
            }
        }
        cell[axis] += last[axis] > cell[axis] ? 1 : -1;
        cells_[indexOf(cell)].push_back(id);
        ++entries_;
    }
}

std::vector<int> SegmentGrid::find(std::span<const Bounds> boxes) const {
    std::vector<int> cells;
    for (const Bounds& box : boxes) {
        addCells(box, cells);
    }
    sortUnique(cells);
    std::vector<int> found;
    for (const int cell : cells) {
        found.insert(found.end(), cells_[cell].begin(), cells_[cell].end());
    }
    sortUnique(found);
    return found;
}

/// Appends those that the box meets.
void SegmentGrid::addCells(const Bounds& box, std::vector<int>& cells) const {
    const Cell low = cellOf(box.low - kPad * cellSize_);
    const Cell high = cellOf(box.high + kPad * cellSize_);
    for (int z = low[2]; z <= high[2]; ++z) {
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int x = low[0]; x <= high[0]; ++x) {
                cells.push_back(indexOf({x, y, z}));
            }
        }
    }
}

IspcSet::IspcSet(const SurfaceMesh& mesh, BodyModel& model)
    : mesh_(mesh), tree_(mesh, livingTriangles(mesh)) {
    tree_.prepareToUpdate();
    makeRoom();
    const IspcCaster caster(mesh, tree_, model.pieceOfVertex, model.edgeLength, rays_);
    for (int ray = 0; ray < static_cast<int>(ofRay_.size()); ++ray) {
        if (const std::optional<CastIspc> ispc = cast(caster, model, ray)) {
            remember(*ispc, ray, static_cast<int>(model.ispcs.size()));
            model.ispcs.push_back(ispc->constraint);
            model.ispcMeshTriangle.push_back(ispc->meshTriangle);
        }
    }
    refillGrid(model);
}

IspcSet::IspcSet(const SurfaceMesh& mesh, const BodyModel& model, ByteReader& from)
    : mesh_(mesh), tree_(mesh, livingTriangles(mesh)) {
    tree_.prepareToUpdate();
    archive(from);
    refillGrid(model);
}

std::optional<CastIspc> IspcSet::cast(const IspcCaster& caster, const BodyModel& model,
                                      int ray) const {
    const int v = vertexOf(ray);
    return caster.cast(v, ray - v * raysPerVertex(rays_), model.vertexAreas[v]);
}

/// For the rays of all vertices, and lists of all triangles.
void IspcSet::makeRoom() {
    const std::size_t rays = static_cast<std::size_t>(mesh_.vertexCount()) * raysPerVertex(rays_);
    ofRay_.resize(rays, -1);
    next_.resize(rays, -1);
    previous_.resize(rays, -1);
    firstOn_.resize(mesh_.triangleSlots(), -1);
}

void IspcSet::refillGrid(const BodyModel& model) {
    grid_ = SegmentGrid(boxOf(mesh_.restPositions()), static_cast<int>(model.ispcs.size()));
    for (std::size_t slot = 0; slot < model.ispcs.size(); ++slot) {
        addToGrid(model.ispcs[slot], rayOf_[slot]);
    }
}

void IspcSet::addToGrid(const shared::IspcConstraint& ispc, int ray) {
    grid_.add(ray, mesh_.restPosition(static_cast<int>(ispc.vertex)), restEnd(mesh_, ispc));
}

void IspcSet::remember(const CastIspc& ispc, int ray, int slot) {
    ofRay_[ray] = slot;
    rayOf_.resize(std::max(rayOf_.size(), static_cast<std::size_t>(slot) + 1), -1);
    rayOf_[slot] = ray;
    next_[ray] = firstOn_[ispc.meshTriangle];
    previous_[ray] = -1;
    if (next_[ray] >= 0) {
        previous_[next_[ray]] = ray;
    }
    firstOn_[ispc.meshTriangle] = ray;
}

void IspcSet::forget(int ray, int triangle) {
    ofRay_[ray] = -1;
    if (previous_[ray] >= 0) {
        next_[previous_[ray]] = next_[ray];
    } else {
        firstOn_[triangle] = next_[ray];
    }
    if (next_[ray] >= 0) {
        previous_[next_[ray]] = previous_[ray];
    }
}

template <class F>
void IspcSet::forEachEndingOn(int triangle, F&& f) const {
    for (int ray = firstOn_[triangle]; ray >= 0; ray = next_[ray]) {
        f(ray);
    }
}

void IspcSet::update(BodyModel& model, std::span<const int> changed, const LabelChange& labels,
                     Editor& editor) {
    makeRoom();
    tree_.update(changed);
    castRays(model, raysToCast(model, changed, labels), editor);
    if (grid_.overfull()) {
        refillGrid(model);
    }
}

void IspcSet::castAnew(BodyModel& model, IspcRays rays, Editor& editor) {
    for (std::size_t slot = 0; slot < model.ispcs.size(); ++slot) {
        editor.remove(static_cast<int>(slot));
    }
    rays_ = rays;
    waiting_.clear();
    ofRay_.clear();
    next_.clear();
    previous_.clear();
    firstOn_.clear();
    makeRoom();
    std::vector<int> all(ofRay_.size());
    std::iota(all.begin(), all.end(), 0);
    castRays(model, all, editor);
    refillGrid(model);
}

/// Ascending; those that have an ISPC lose it.
void IspcSet::castRays(BodyModel& model, std::span<const int> rays, Editor& editor) {
    for (const int ray : rays) {
        if (const int slot = ofRay_[ray]; slot >= 0) {
            forget(ray, model.ispcMeshTriangle[slot]);
            editor.remove(slot);
        }
    }
    const IspcCaster caster(mesh_, tree_, model.pieceOfVertex, model.edgeLength, rays_);
    for (const int ray : rays) {
        const std::optional<CastIspc> ispc = cast(caster, model, ray);
        if (ispc && mesh_.absent(ispc->meshTriangle)) {
            waiting_.push_back(ray);
        } else if (ispc) {
            const int slot = editor.add(ispc->constraint);
            model.ispcMeshTriangle.resize(model.ispcs.size(), -1);
            model.ispcMeshTriangle[slot] = ispc->meshTriangle;
            remember(*ispc, ray, slot);
            addToGrid(ispc->constraint, ray);
        }
    }
    editor.close([&](int from, int to) {
        model.ispcMeshTriangle[to] = model.ispcMeshTriangle[from];
        rayOf_[to] = rayOf_[from];
        ofRay_[rayOf_[to]] = to;
    });
    model.ispcMeshTriangle.resize(model.ispcs.size());
    rayOf_.resize(model.ispcs.size());
}

/// Rays that must be cast, ascending.
std::vector<int> IspcSet::raysToCast(const BodyModel& model, std::span<const int> changed,
                                     const LabelChange& labels) {
    std::vector<int> rays;
    if (mesh_.openStroke() < 0) {
        rays = std::exchange(waiting_, {});
    }
    for (const int t : changed) {
        forEachEndingOn(t, [&](int ray) { rays.push_back(ray); });
        if (mesh_.alive(t)) {
            for (const int v : mesh_.triangle(t)) {
                addRaysOf(v, rays);
            }
        }
    }
    addSeparated(model, labels, rays);
    sortUnique(rays);
    const std::size_t known = rays.size();
    addCrossed(model, changed, rays);
    if (rays.size() > known) {
        sortUnique(rays);
    }
    return rays;
}

void IspcSet::addRaysOf(int vertex, std::vector<int>& rays) const {
    const int count = raysPerVertex(rays_);
    for (int ray = vertex * count; ray < (vertex + 1) * count; ++ray) {
        rays.push_back(ray);
    }
}

bool IspcSet::isSeparated(const BodyModel& model, int ray) const {
    const int slot = ofRay_[ray];
    return slot >= 0 &&
           model.pieceOfVertex[vertexOf(ray)] != model.pieceOfVertex[model.ispcs[slot].t0];
}

void IspcSet::addSeparated(const BodyModel& model, const LabelChange& labels,
                           std::vector<int>& rays) const {
    const auto check = [&](int ray) {
        if (isSeparated(model, ray)) {
            rays.push_back(ray);
        }
    };
    std::vector<int> own;
    for (const LabelMove& move : labels.moves) {
        own.clear();
        addRaysOf(move.vertex, own);
        std::ranges::for_each(own, check);
        if (labels.piecesChanged && move.from >= 0) {
            mesh_.forEachOutgoing(move.vertex, [&](int h) { forEachEndingOn(h / 3, check); });
        }
    }
}

/// Of those that are not in `rays` (ascending) yet.
void IspcSet::addCrossed(const BodyModel& model, std::span<const int> changed,
                         std::vector<int>& rays) const {
    const std::vector<int> walls = newWalls(mesh_, changed);
    std::vector<Bounds> boxes(walls.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
        for (const int v : mesh_.triangle(walls[i])) {
            boxes[i].add(mesh_.restPosition(v));
        }
    }
    const RayTree wallTree(mesh_, walls);
    const auto known = static_cast<std::ptrdiff_t>(rays.size());
    for (const int ray : grid_.find(boxes)) {
        const int slot = ofRay_[ray];
        if (slot < 0 || std::binary_search(rays.begin(), rays.begin() + known, ray)) {
            continue;
        }
        if (wallTree.crosses(mesh_.restPosition(vertexOf(ray)),
                             restEnd(mesh_, model.ispcs[slot]))) {
            rays.push_back(ray);
        }
    }
}

}  // namespace kerf
