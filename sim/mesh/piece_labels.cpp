#include "sim/mesh/piece_labels.h"

#include "sim/base/containers.h"
#include "sim/base/pausing.h"
#include "sim/mesh/piece_figures.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

constexpr std::size_t kAhead = 8;  // what is asked of memory before it is needed

/// Whether all pieces are those that there were: what fell apart may have been shells of one piece,
/// which it still is.
bool isAsBefore(const LabelChange& change, const std::vector<int>& before) {
    const int count = before.empty() ? 0 : std::ranges::max(before) + 1;
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    return change.source == all && std::ranges::none_of(change.moves, [](const LabelMove& move) {
               return move.from >= 0 && move.to >= 0;
           });
}

/// Calls f(i) for each i below `count`, with a pause now and then.
template <class F>
void inPortions(std::size_t count, F&& f) {
    constexpr std::size_t kPortion = 4096;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % kPortion == 0) {
            pausePoint();
        }
        f(i);
    }
}

}  // namespace

/// Searches from all changed triangles at once, some triangles each in turn, until all but one of
/// the parts of each piece are known whole. That takes the time of the smaller parts. Triangles
/// know their neighbours, so this is several times as fast as going from vertex to vertex.
class PieceLabels::Splitter {
  public:
    Splitter(const SurfaceMesh& mesh, const std::vector<int>& ofVertex,
             std::vector<int>& placeOfVertex, std::vector<int>& partOfTriangle)
        : mesh_(mesh),
          ofVertex_(ofVertex),
          placeOfVertex_(placeOfVertex),
          partOfTriangle_(partOfTriangle) {}

    /// A connected set of triangles that may grow.
    struct Part {
        std::vector<int> triangles;
        std::size_t next = 0;          ///< the first whose neighbours have not been looked at
        std::vector<int> newVertices;  ///< without a label yet
        int label = -1;                ///< of the piece that it comes from
        bool joined = false;           ///< holds vertices of two pieces
        bool whole() const { return next == triangles.size(); }
    };

    /// Finds the parts; joined() tells where they are not to be used. `seeds`: the corners of the
    /// living ones among `triangles`, each once.
    void run(const std::vector<int>& seeds, std::span<const int> triangles) {
        placeSeeds(seeds, triangles);
        joined_ = std::ranges::any_of(parts_, &Part::joined);
        if (!joined_) {
            for (const auto& [label, group] : partsByLabel()) {
                findLesserParts(label, group);
            }
        }
        if (marked_) {
            forget(parts_);
            forget(cameOff_);
        }
    }

    bool joined() const { return joined_; }
    /// Whole parts that get a label of their own, in a fixed order.
    const std::vector<Part>& cameOff() const { return cameOff_; }
    /// What was seen of the parts that keep theirs; some are empty.
    const std::vector<Part>& stayed() const { return parts_; }

  private:
    static constexpr int kInTurn = 32;
    static constexpr std::size_t kMostInTurn = 3 * kInTurn + 1;  // with room for one not taken

    // Triangles with a common corner are one part from the start. Only where there are several
    // parts, or one that is all new, anyone asks for their triangles.
    void placeSeeds(const std::vector<int>& seeds, std::span<const int> triangles) {
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            placeOfVertex_[seeds[i]] = static_cast<int>(i);
        }
        UnionFind sets(seeds.size());
        for (const int t : triangles) {
            if (mesh_.alive(t)) {
                const Triangle& c = mesh_.triangle(t);
                sets.join(placeOfVertex_[c[0]], placeOfVertex_[c[1]]);
                sets.join(placeOfVertex_[c[0]], placeOfVertex_[c[2]]);
            }
        }
        std::vector<int> partOfSeed(seeds.size(), -1);
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            const int root = sets.root(static_cast<int>(i));
            if (partOfSeed[root] < 0) {
                partOfSeed[root] = static_cast<int>(parts_.size());
                parts_.emplace_back();
            }
            partOfSeed[i] = partOfSeed[root];
            add(seeds[i], parts_[partOfSeed[i]]);
        }
        if (parts_.size() > 1 || (!parts_.empty() && parts_[0].label < 0)) {
            handOut(triangles, partOfSeed);
        }
        for (const int v : seeds) {
            placeOfVertex_[v] = -1;
        }
    }

    void handOut(std::span<const int> triangles, const std::vector<int>& partOfSeed) {
        for (const int t : triangles) {
            if (mesh_.alive(t)) {
                const int seed = placeOfVertex_[mesh_.triangle(t)[0]];
                parts_[partOfSeed[seed]].triangles.push_back(t);
            }
        }
    }

    void add(int vertex, Part& part) const {
        const int label = ofVertex_[vertex];
        if (label < 0) {
            part.newVertices.push_back(vertex);
        } else {
            part.joined = part.joined || (part.label >= 0 && part.label != label);
            part.label = label;
        }
    }

    std::map<int, std::vector<int>> partsByLabel() const {
        std::map<int, std::vector<int>> groups;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            groups[parts_[i].label].push_back(static_cast<int>(i));
        }
        return groups;
    }

    void findLesserParts(int label, std::vector<int> group) {
        // A part of new vertices only is complete, since each of their triangles is new.
        const std::size_t keep = label < 0 ? 0 : 1;
        if (group.size() > keep && label >= 0) {
            mark(group);
        }
        while (group.size() > keep) {
            pausePoint();
            for (std::size_t i = 0; i < group.size() && group.size() > keep;) {
                if (label < 0 || parts_[group[i]].whole()) {
                    cameOff_.push_back(std::exchange(parts_[group[i]], {}));
                    group.erase(group.begin() + static_cast<std::ptrdiff_t>(i));
                } else {
                    expand(group, i);
                    ++i;
                }
            }
        }
    }

    void mark(const std::vector<int>& group) {
        marked_ = true;
        partOfTriangle_.resize(mesh_.triangleSlots(), -1);
        for (const int part : group) {
            for (const int t : parts_[part].triangles) {
                partOfTriangle_[t] = part;
            }
        }
    }

    // Looks at the neighbours of some triangles; parts that they meet become part of this one.
    // Whether a neighbour is new can't be foreseen, so it is taken down without asking.
    void expand(std::vector<int>& group, std::size_t& index) {
        const int part = group[index];
        std::vector<int>& triangles = parts_[part].triangles;
        std::size_t& next = parts_[part].next;
        std::size_t size = triangles.size();
        triangles.resize(size + kMostInTurn);
        for (int i = 0; i < kInTurn && next < size; ++i) {
            const int triangle = triangles[next++];
            __builtin_prefetch(&mesh_.twins(triangles[std::min(next + kAhead, size - 1)]));
            for (const int twin : mesh_.twins(triangle)) {
                const int other = SurfaceMesh::triangleOf(twin);
                const int owner = partOfTriangle_[other];
                if (owner >= 0 && owner != part) [[unlikely]] {
                    triangles.resize(size);
                    absorb(part, owner);
                    size = triangles.size();
                    triangles.resize(size + kMostInTurn);
                    const auto gone = std::find(group.begin(), group.end(), owner);
                    index -= gone - group.begin() < static_cast<std::ptrdiff_t>(index) ? 1 : 0;
                    group.erase(gone);
                }
                partOfTriangle_[other] = part;
                triangles[size] = other;
                size += owner < 0 ? 1 : 0;
            }
        }
        triangles.resize(size);
    }

    // Triangles already looked at stay in front, so that `next` holds.
    void absorb(int part, int other) {
        Part& into = parts_[part];
        Part from = std::exchange(parts_[other], {});
        const auto fresh = from.triangles.begin() + static_cast<std::ptrdiff_t>(from.next);
        into.triangles.insert(into.triangles.begin() + static_cast<std::ptrdiff_t>(into.next),
                              from.triangles.begin(), fresh);
        into.next += from.next;
        into.triangles.insert(into.triangles.end(), fresh, from.triangles.end());
        into.newVertices.insert(into.newVertices.end(), from.newVertices.begin(),
                                from.newVertices.end());
        for (const int t : from.triangles) {
            partOfTriangle_[t] = part;
        }
    }

    void forget(const std::vector<Part>& parts) {
        for (const Part& part : parts) {
            for (const int t : part.triangles) {
                if (t < static_cast<int>(partOfTriangle_.size())) {
                    partOfTriangle_[t] = -1;
                }
            }
        }
    }

    const SurfaceMesh& mesh_;
    const std::vector<int>& ofVertex_;
    std::vector<int>& placeOfVertex_;
    std::vector<int>& partOfTriangle_;
    std::vector<Part> parts_;
    std::vector<Part> cameOff_;
    bool joined_ = false;
    bool marked_ = false;  ///< triangles know their parts
};

PieceLabels::PieceLabels(const SurfaceMesh& mesh, Measures measures) : measures_(measures) {
    UnionFind pieces = shellsOf(mesh);
    hasCavities_ = joinCavities(mesh, pieces);
    labelAll(mesh, std::move(pieces));
}

/// Nothing that a cut makes is a cavity where there was none.
UnionFind PieceLabels::piecesOf(const SurfaceMesh& mesh) const {
    UnionFind pieces = shellsOf(mesh);
    if (hasCavities_) {
        joinCavities(mesh, pieces);
    }
    return pieces;
}

void PieceLabels::measureVolumes(const SurfaceMesh& mesh) {
    if (measures()) {
        return;
    }
    measures_ = Measures::volumes;
    shares_.reserve(withGrowthRoom(mesh.triangleSlots()));
    shares_.resize(mesh.triangleSlots());
    for (const int t : livingTriangles(mesh)) {
        shares_[t] = shareOf(mesh, t);
        pieces_[ofVertex_[mesh.triangle(t)[0]]].restVolume += shares_[t].volume;
    }
}

/// `sets`: the vertices of each piece.
void PieceLabels::labelAll(const SurfaceMesh& mesh, UnionFind sets) {
    pieces_.clear();
    for (std::vector<int>* labels : {&ofVertex_, &placeOfVertex_}) {
        labels->reserve(withGrowthRoom(mesh.vertexCount()));
    }
    counted_.reserve(withGrowthRoom(mesh.triangleSlots()));
    ofVertex_.assign(mesh.vertexCount(), -1);
    placeOfVertex_.assign(mesh.vertexCount(), -1);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (!isUsed(mesh, v)) {
            continue;
        }
        const int lowest = sets.root(v);
        if (lowest == v) {
            ofVertex_[v] = static_cast<int>(pieces_.size());
            pieces_.emplace_back();
        }
        ofVertex_[v] = ofVertex_[lowest];
        ++pieces_[ofVertex_[v]].vertices;
    }
    counted_.assign(mesh.triangleSlots(), {});
    if (measures()) {
        shares_.reserve(withGrowthRoom(mesh.triangleSlots()));
        shares_.assign(mesh.triangleSlots(), {});
    }
    for (const int t : livingTriangles(mesh)) {
        count(mesh, t);
    }
}

LabelChange PieceLabels::update(const SurfaceMesh& mesh, std::span<const int> triangles) {
    LabelChange change;
    const auto oldVertices = ofVertex_.size();
    change.source.resize(pieces_.size());
    std::iota(change.source.begin(), change.source.end(), 0);
    ofVertex_.resize(mesh.vertexCount(), -1);
    placeOfVertex_.resize(mesh.vertexCount(), -1);
    counted_.resize(mesh.triangleSlots());
    shares_.resize(measures() ? mesh.triangleSlots() : 0);
    for (const int t : triangles) {
        discount(t);
    }
    const std::vector<int> touched = touchedVertices(mesh, triangles, change.moves);
    Splitter splitter(mesh, ofVertex_, placeOfVertex_, partOfTriangle_);
    splitter.run(touched, triangles);
    const int vanished = firstEmptyPiece();
    const bool youngestVanished = onlyEmptyFrom(vanished) && splitter.cameOff().empty();
    const bool asksForCavities = hasCavities_ && !splitter.cameOff().empty();
    if (splitter.joined() || asksForCavities || (vanished >= 0 && !youngestVanished)) {
        return labelAnew(mesh, labelsBefore(change, oldVertices));
    }
    for (const Splitter::Part& part : splitter.cameOff()) {
        change.source.push_back(part.label);
        comeOff(mesh, part.triangles, part.label, change.moves);
    }
    for (const Splitter::Part& part : splitter.stayed()) {
        labelNewVertices(part.newVertices, part.label, change.moves);
    }
    for (const int t : triangles) {
        if (mesh.alive(t)) {
            count(mesh, t);
        }
    }
    if (vanished >= 0) {
        pieces_.resize(vanished);
        change.source.resize(vanished);
    }
    change.piecesChanged = vanished >= 0 || !splitter.cameOff().empty();
    return change;
}

/// -1 for none.
int PieceLabels::firstEmptyPiece() const {
    const auto empty = std::ranges::find(pieces_, 0, &PieceContent::vertices);
    return empty == pieces_.end() ? -1 : static_cast<int>(empty - pieces_.begin());
}

bool PieceLabels::onlyEmptyFrom(int label) const {
    return label >= 0 && std::all_of(pieces_.begin() + label, pieces_.end(),
                                     [](const PieceContent& p) { return p.vertices == 0; });
}

std::vector<int> PieceLabels::labelsBefore(const LabelChange& change, std::size_t vertices) const {
    std::vector<int> before = ofVertex_;
    for (const LabelMove& move : change.moves) {
        before[move.vertex] = move.from;
    }
    std::fill(before.begin() + static_cast<std::ptrdiff_t>(vertices), before.end(), -1);
    return before;
}

LabelChange PieceLabels::labelAnew(const SurfaceMesh& mesh, const std::vector<int>& before) {
    labelAll(mesh, piecesOf(mesh));
    LabelChange change;
    change.source.assign(pieces_.size(), -1);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (const int label = ofVertex_[v]; label >= 0 && change.source[label] < 0) {
            change.source[label] = before[v];
        }
    }
    keepOrder(change);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (before[v] != ofVertex_[v]) {
            change.moves.push_back({v, before[v], ofVertex_[v]});
        }
    }
    change.piecesChanged = !isAsBefore(change, before);
    return change;
}

/// Pieces follow each other as their sources do; those that are all new come last.
void PieceLabels::keepOrder(LabelChange& change) {
    std::vector<int> order(pieces_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(
        order, {}, [&](int label) { return static_cast<std::uint32_t>(change.source[label]); });
    std::vector<int> labelAfter(order.size());
    const std::vector<PieceContent> pieces = pieces_;
    const std::vector<int> source = change.source;
    for (std::size_t i = 0; i < order.size(); ++i) {
        labelAfter[order[i]] = static_cast<int>(i);
        pieces_[i] = pieces[order[i]];
        change.source[i] = source[order[i]];
    }
    for (int& label : ofVertex_) {
        label = label < 0 ? -1 : labelAfter[label];
    }
}

/// The corners of the living triangles, each once. Vertices that died lose their label.
std::vector<int> PieceLabels::touchedVertices(const SurfaceMesh& mesh,
                                              std::span<const int> triangles,
                                              std::vector<LabelMove>& moves) {
    std::vector<int> touched;
    for (const int t : triangles) {
        for (const int v : counted_[t].corners) {
            if (v >= 0 && mesh.outgoing(v) < 0) {
                setLabel(v, -1, moves);
            }
        }
        for (int k = 0; k < 3 && mesh.alive(t); ++k) {
            const int v = mesh.triangle(t)[k];
            if (std::exchange(placeOfVertex_[v], 0) < 0) {
                touched.push_back(v);
            }
        }
    }
    return touched;
}

/// `from`: the label of those that are counted.
void PieceLabels::comeOff(const SurfaceMesh& mesh, const std::vector<int>& triangles, int from,
                          std::vector<LabelMove>& moves) {
    const int label = static_cast<int>(pieces_.size());
    pieces_.emplace_back();
    if (from >= 0) {
        moveShares(triangles, from, label);
    }
    moves.reserve(moves.size() + triangles.size());
    inPortions(triangles.size(), [&](std::size_t i) {
        __builtin_prefetch(&mesh.triangle(triangles[std::min(i + kAhead, triangles.size() - 1)]));
        for (const int v : mesh.triangle(triangles[i])) {
            setLabel(v, label, moves);
        }
    });
}

void PieceLabels::moveShares(const std::vector<int>& triangles, int from, int to) {
    PieceContent less = pieces_[from];
    PieceContent more = pieces_[to];
    inPortions(triangles.size(), [&](std::size_t i) {
        if (const int t = triangles[i]; counted_[t].counted) {
            addShare(t, -1, less);
            addShare(t, 1, more);
        }
    });
    pieces_[from] = less;
    pieces_[to] = more;
}

void PieceLabels::labelNewVertices(const std::vector<int>& vertices, int label,
                                   std::vector<LabelMove>& moves) {
    for (const int v : vertices) {
        setLabel(v, label, moves);
    }
}

void PieceLabels::setLabel(int vertex, int label, std::vector<LabelMove>& moves) {
    const int from = std::exchange(ofVertex_[vertex], label);
    if (from == label) {
        return;
    }
    if (from >= 0) {
        --pieces_[from].vertices;
    }
    if (label >= 0) {
        ++pieces_[label].vertices;
    }
    moves.push_back({vertex, from, label});
}

void PieceLabels::count(const SurfaceMesh& mesh, int triangle) {
    const Triangle& corners = mesh.triangle(triangle);
    Counted& counted = counted_[triangle];  // by members, which is twice as fast
    counted.corners = corners;
    counted.counted = true;
    if (measures()) {
        shares_[triangle] = shareOf(mesh, triangle);
    }
    addShare(triangle, 1, pieces_[ofVertex_[corners[0]]]);
}

void PieceLabels::discount(int triangle) {
    Counted& counted = counted_[triangle];
    if (std::exchange(counted.counted, false)) {
        addShare(triangle, -1, pieces_[ofVertex_[counted.corners[0]]]);
    }
}

void PieceLabels::addShare(int triangle, int sign, PieceContent& piece) const {
    piece.triangles += sign;
    if (measures()) {
        piece.restVolume += sign * shares_[triangle].volume;
        piece.restArea += sign * shares_[triangle].area;
    }
}

PieceLabels::Share PieceLabels::shareOf(const SurfaceMesh& mesh, int triangle) const {
    const auto& [i, j, k] = mesh.triangle(triangle);
    const Vec3 &a = mesh.restPosition(i), &b = mesh.restPosition(j), &c = mesh.restPosition(k);
    return {tetrahedronVolume(a, b, c),
            measures_ == Measures::volumesAndAreas ? triangleArea(a, b, c) : 0.0};
}

}  // namespace kerf
