#include "sim/repair/double_triangles.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"
#include "sim/repair/soup_editing.h"

namespace kerf::repair {

namespace {

/// Whether a triangle's corners run as those of the sorted one.
bool runsUp(const Triangle& t) {
    const auto lowest = std::ranges::min_element(t) - t.begin();
    return t[(lowest + 1) % 3] < t[(lowest + 2) % 3];
}

/// The triangles with the same three corners, ascending, by the way they face.
struct Copies {
    std::vector<int> up;
    std::vector<int> down;

    std::size_t count() const { return up.size() + down.size(); }
    bool isDouble() const { return count() > 1; }
    bool isFlap() const { return !up.empty() && !down.empty(); }
    /// The copies of the way that most face.
    const std::vector<int>& most() const { return up.size() >= down.size() ? up : down; }
};

std::vector<Copies> copiesIn(const TriangleSoup& soup) {
    std::vector<int> order(soup.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    const auto cornersOf = [&](int t) { return sortedCorners(soup.triangles[t]); };
    std::ranges::stable_sort(order, {}, cornersOf);
    std::vector<Copies> all;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || cornersOf(order[i]) != cornersOf(order[i - 1])) {
            all.emplace_back();
        }
        (runsUp(soup.triangles[order[i]]) ? all.back().up : all.back().down).push_back(order[i]);
    }
    return all;
}

/// A sheet of doubles and what meets it at its border, by the lengths of edges [m].
struct Sheet {
    double area = 0;   ///< [m^2], of one copy
    double odd = 0;    ///< with an odd number of single triangles
    double even = 0;   ///< with an even number of them
    double other = 0;  ///< with nothing else, or with further sheets

    /// Whether it is closed but for small holes: the border of a flat sheet is longer than 3.5
    /// times the root of its area.
    bool isClosed() const {
        const double border = odd + even + other;
        return border * border < area;
    }
};

/// Sheets of triangles that are there several times, and what meets them.
class Sheets {
  public:
    Sheets(const TriangleSoup& soup, const std::vector<Copies>& copies)
        : soup_(soup), copies_(copies), sets_(copies.size()), sheets_(copies.size()) {
        std::vector<Triangle> one;
        one.reserve(copies.size());
        for (const Copies& each : copies) {
            one.push_back(soup.triangles[each.most().front()]);
        }
        const std::vector<Side> sides = sidesByEdge(one);
        forEachEdge(sides, [&](const Side* begin, const Side* end) { joinAt(begin, end); });
        forEachEdge(sides, [&](const Side* begin, const Side* end) { noteBorder(begin, end); });
        for (int i = 0; i < static_cast<int>(copies.size()); ++i) {
            sheets_[sets_.root(i)].area += triangleArea(cornersOf(soup, copies[i].most().front()));
        }
    }

    const Sheet& sheetOf(int copies) { return sheets_[sets_.root(copies)]; }

  private:
    bool isDouble(const Side& side) const { return copies_[side.triangle()].isDouble(); }

    void joinAt(const Side* begin, const Side* end) {
        if (end - begin == 2 &&
            std::all_of(begin, end, [&](const Side& s) { return isDouble(s); })) {
            sets_.join(begin->triangle(), begin[1].triangle());
        }
    }

    void noteBorder(const Side* begin, const Side* end) {
        const auto doubles = std::count_if(begin, end, [&](const Side& s) { return isDouble(s); });
        const auto singles = end - begin - doubles;
        if (doubles == 2 && singles == 0) {
            return;
        }
        const double length = (soup_.positions[begin->high] - soup_.positions[begin->low]).norm();
        for (const Side* side = begin; side != end; ++side) {
            if (isDouble(*side)) {
                Sheet& sheet = sheets_[sets_.root(side->triangle())];
                double& sum = doubles > 1 || singles == 0 ? sheet.other
                              : singles % 2 == 1          ? sheet.odd
                                                          : sheet.even;
                sum += length;
            }
        }
    }

    const TriangleSoup& soup_;
    const std::vector<Copies>& copies_;
    UnionFind sets_;
    std::vector<Sheet> sheets_;  ///< by their lowest copies
};

/// How many copies stay.
std::size_t numberToKeep(const Copies& copies, const Sheet& sheet, bool onlyDoubles) {
    const bool alike = !copies.isFlap();
    if (sheet.odd > sheet.even || sheet.isClosed()) {
        return 1;
    }
    if (sheet.even > 0) {
        return alike && copies.count() % 2 == 0 ? 2 : copies.count() % 2;
    }
    return alike || onlyDoubles ? 1 : 0;
}

}  // namespace

int dropDoubles(TriangleSoup& soup) {
    const std::vector<Copies> all = copiesIn(soup);
    const auto doubles = std::ranges::count_if(all, &Copies::isDouble);
    if (doubles == 0) {
        return 0;
    }
    Sheets sheets(soup, all);
    const bool onlyDoubles = doubles == static_cast<std::ptrdiff_t>(all.size());
    std::vector<char> keep(soup.triangles.size(), 1);
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        if (!all[i].isDouble()) {
            continue;
        }
        for (const std::vector<int>* each : {&all[i].up, &all[i].down}) {
            std::ranges::for_each(*each, [&](int t) { keep[t] = 0; });
        }
        const std::vector<int>& most = all[i].most();
        const std::size_t count = numberToKeep(all[i], sheets.sheetOf(i), onlyDoubles);
        for (std::size_t k = 0; k < std::min(count, most.size()); ++k) {
            keep[most[k]] = 1;
        }
    }
    return keepTriangles(soup, keep);
}

}  // namespace kerf::repair
