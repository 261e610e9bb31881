#include "sim/cut/patch/wound.h"

#include "sim/cut/wall_copies.h"

namespace kerf::cut {

namespace {

class WoundFinder {
  public:
    explicit WoundFinder(const SurfaceMesh& mesh) : mesh_(mesh) {
        for (const int t : absentTriangles(mesh)) {
            if (isMinus(t)) {
                minusAt_[pointsOf(mesh_, t)].push_back(t);
            }
        }
    }

    std::vector<Wound> run() {
        std::vector<Wound> wounds;
        for (const int t : absentTriangles(mesh_)) {
            if (!isMinus(t) && !seen_.contains(t)) {
                wounds.push_back(woundAround(t));
            }
        }
        return wounds;
    }

  private:
    bool isMinus(int t) const { return mesh_.wallLabel(t) % 2 == 1; }

    Wound woundAround(int first) {
        Wound wound;
        wound.plus = sheetAround(first, wound.endsInside);
        findMirrors(wound);
        if (!wound.endsInside && !wound.unmirrored) {
            findLoops(wound);
        }
        return wound;
    }

    std::vector<int> sheetAround(int first, bool& endsInside) {
        std::vector<int> sheet;
        std::vector<int> open{first};
        seen_.insert(first);
        while (!open.empty()) {
            const int t = open.back();
            open.pop_back();
            sheet.push_back(t);
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                const int other = mesh_.twin(h) / 3;
                if (!mesh_.absent(other)) {
                    continue;
                }
                if (isMinus(other)) {
                    endsInside = true;
                } else if (seen_.insert(other).second) {
                    open.push_back(other);
                }
            }
        }
        std::sort(sheet.begin(), sheet.end());
        return sheet;
    }

    void findMirrors(Wound& wound) {
        for (const int t : wound.plus) {
            const auto found = minusAt_.find(pointsOf(mesh_, t));
            if (found == minusAt_.end() || found->second.size() != 1) {
                wound.unmirrored = true;
                return;
            }
            mirrorOf_[t] = found->second.front();
            wound.minus.push_back(found->second.front());
        }
    }

    /// The sheet's own border, by way of its triangles alone.
    void findLoops(Wound& wound) {
        std::set<int> done;
        for (const int t : wound.plus) {
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                if (isRim(h) && !done.contains(h)) {
                    wound.loops.push_back(loopFrom(h, done, wound));
                }
            }
        }
        wound.unmirrored =
            wound.unmirrored || rimEdges(wound.minus) != static_cast<int>(done.size());
    }

    bool isRim(int h) const { return !mesh_.absent(mesh_.twin(h) / 3); }

    int rimEdges(const std::vector<int>& triangles) const {
        int count = 0;
        for (const int t : triangles) {
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                count += isRim(h);
            }
        }
        return count;
    }

    std::vector<WoundEdge> loopFrom(int first, std::set<int>& done, Wound& wound) const {
        std::vector<WoundEdge> loop;
        int h = first;
        do {
            done.insert(h);
            loop.push_back({h, mirrorOfEdge(h)});
            h = nextRim(h);
        } while (h != first);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int minus = loop[i].minus;
            const int after = loop[(i + 1) % loop.size()].minus;
            if (minus < 0 || after < 0 || !isRim(minus) ||
                mesh_.origin(minus) != mesh_.target(after)) {
                wound.unmirrored = true;
            }
        }
        return loop;
    }

    int nextRim(int h) const {
        int g = SurfaceMesh::next(h);
        while (!isRim(g)) {
            g = SurfaceMesh::next(mesh_.twin(g));
        }
        return g;
    }

    /// -1 for none.
    int mirrorOfEdge(int h) const {
        const int t = mirrorOf_.at(h / 3);
        for (int g = 3 * t; g < 3 * t + 3; ++g) {
            if (mesh_.firstCopy(mesh_.origin(g)) == mesh_.firstCopy(mesh_.target(h)) &&
                mesh_.firstCopy(mesh_.target(g)) == mesh_.firstCopy(mesh_.origin(h))) {
                return g;
            }
        }
        return -1;
    }

    const SurfaceMesh& mesh_;
    std::map<Triangle, std::vector<int>> minusAt_;
    std::map<int, int> mirrorOf_;
    std::set<int> seen_;
};

}  // namespace

std::vector<Wound> findWounds(const SurfaceMesh& mesh) {
    return WoundFinder(mesh).run();
}

}  // namespace kerf::cut
