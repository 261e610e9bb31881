#include "sim/cut/surface/candidate_search.h"

#include <cstddef>
#include <vector>

#include "sim/base/stopwatch.h"

namespace kerf::cut {

namespace {

long askFinder(const CandidateSearch& search) {
    const std::vector<int> near = search.finder.near(search.reach);
    for (const int t : near) {
        search.isNear(t);
    }
    return static_cast<long>(near.size());
}

long askAll(const CandidateSearch& search) {
    long tests = 0;
    for (int t = 0; t < search.mesh.triangleSlots(); ++t) {
        if (search.mesh.alive(t)) {
            search.isNear(t);
            ++tests;
        }
    }
    return tests;
}

/// The paper's search over adjacent triangles.
class Walk {
  public:
    explicit Walk(const CandidateSearch& search)
        : search_(search), visited_(static_cast<std::size_t>(search.mesh.triangleSlots())) {}

    SearchWork run() {
        const Stopwatch watch;
        for (int t = 0; t < search_.mesh.triangleSlots(); ++t) {
            if (search_.mesh.alive(t) && visit(t)) {
                walkFrom(t);
                if (++work_.seeds == 1) {
                    work_.walkMilliseconds = watch.milliseconds();
                }
            }
        }
        return work_;
    }

  private:
    /// Whether a triangle is met now, and near.
    bool visit(int t) {
        if (visited_[t]) {
            return false;
        }
        visited_[t] = true;
        ++work_.tests;
        return search_.isNear(t);
    }

    void walkFrom(int seed) {
        std::vector<int> toTraverse{seed};
        while (!toTraverse.empty()) {
            const int t = toTraverse.back();
            toTraverse.pop_back();
            for (const int twin : search_.mesh.twins(t)) {
                if (const int neighbour = SurfaceMesh::triangleOf(twin); visit(neighbour)) {
                    toTraverse.push_back(neighbour);
                }
            }
        }
    }

    const CandidateSearch& search_;
    std::vector<bool> visited_;
    SearchWork work_;
};

SearchWork searchBy(const CandidateSearch& search) {
    SearchWork work;
    switch (search.way) {
        case CutSearch::tree:
            work.tests = askFinder(search);
            break;
        case CutSearch::adjacency:
            work = Walk(search).run();
            break;
        case CutSearch::all:
            work.tests = askAll(search);
            break;
    }
    return work;
}

}  // namespace

SearchWork searchCandidates(const CandidateSearch& search) {
    const Stopwatch watch;
    SearchWork work = searchBy(search);
    work.milliseconds = watch.milliseconds();
    return work;
}

}  // namespace kerf::cut
