#include "app/import/repair/double_triangles.h"

#include "sim/base/containers.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"
#include "sim/repair/soup_editing.h"

namespace kerf::app {

namespace {

using repair::Side;

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
    const auto cornersOf = [&](int t) { return repair::sortedCorners(soup.triangles[t]); };
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
struct DoubleSheet {
    double area = 0;        ///< [m^2], of one copy
    double border = 0;      ///< the length of all of it
    double odd = 0;         ///< where an odd number of copies closes the surface
    double even = 0;        ///< where an even number does
    bool meetsOdd = false;  ///< whether an odd number of single triangles meets it and others
    bool flap = false;      ///< whether copies face opposite ways
    int kept = -1;  ///< whether the number of copies that stay is odd; -1 while that is open

    /// Whether it is closed but for small holes: the border of a flat sheet is longer than 3.5
    /// times the root of its area.
    bool isClosed() const { return border * border < area; }
};

/// An edge at the border of sheets.
struct BorderEdge {
    std::vector<int> sheets;  ///< one for each double
    int singles;              ///< triangles that are no doubles
    double length;            ///< [m]
};

/// Sheets of triangles that are there several times, and how many copies close the surface.
class DoubleSheets {
  public:
    DoubleSheets(const TriangleSoup& soup, const std::vector<Copies>& copies)
        : soup_(soup), copies_(copies), sets_(copies.size()), sheets_(copies.size()) {
        const std::vector<Side> sides = repair::sidesByEdge(mapped(
            copies, [&](const Copies& each) { return soup.triangles[each.most().front()]; }));
        forEachEdge(sides, [&](const Side* begin, const Side* end) { joinAt(begin, end); });
        forEachEdge(sides, [&](const Side* begin, const Side* end) { noteBorder(begin, end); });
        measure();
        decide();
    }

    /// Whether the number of copies that stay is odd.
    bool keepsOdd(int copies) { return sheets_[sets_.root(copies)].kept == 1; }

  private:
    bool isDouble(const Side& side) const { return copies_[side.triangle()].isDouble(); }

    void joinAt(const Side* begin, const Side* end) {
        if (end - begin == 2 &&
            std::all_of(begin, end, [&](const Side& s) { return isDouble(s); })) {
            sets_.join(begin->triangle(), begin[1].triangle());
        }
    }

    void noteBorder(const Side* begin, const Side* end) {
        BorderEdge edge{{}, 0, (soup_.positions[begin->high] - soup_.positions[begin->low]).norm()};
        for (const Side* side = begin; side != end; ++side) {
            if (isDouble(*side)) {
                edge.sheets.push_back(sets_.root(side->triangle()));
            } else {
                ++edge.singles;
            }
        }
        const bool isInner = edge.sheets.size() == 2 && edge.singles == 0;
        if (!edge.sheets.empty() && !isInner) {
            edges_.push_back(std::move(edge));
        }
    }

    void measure() {
        for (int i = 0; i < static_cast<int>(copies_.size()); ++i) {
            if (copies_[i].isDouble()) {
                DoubleSheet& sheet = sheets_[sets_.root(i)];
                sheet.area += triangleArea(repair::cornersOf(soup_, copies_[i].most().front()));
                sheet.flap = sheet.flap || copies_[i].isFlap();
                open_.push_back(sets_.root(i));
            }
        }
        sortUnique(open_);
        for (const BorderEdge& edge : edges_) {
            for (const int sheet : edge.sheets) {
                sheets_[sheet].border += edge.length;
                sheets_[sheet].meetsOdd |= edge.sheets.size() > 1 && edge.singles % 2 == 1;
            }
        }
    }

    /// Sheets that single triangles tell about come first, then those beside them, as they count as
    /// single triangles then. Where none is told about, the largest one begins.
    void decide() {
        const bool onlyDoubles = std::ranges::all_of(copies_, &Copies::isDouble);
        for (const int sheet : open_) {
            sheets_[sheet].kept = sheets_[sheet].isClosed() ? 1 : -1;
        }
        while (std::ranges::any_of(open_, [&](int s) { return sheets_[s].kept < 0; })) {
            if (!decideByBorders() && !beginWithLargest()) {
                for (const int each : open_) {
                    DoubleSheet& sheet = sheets_[each];
                    sheet.kept = sheet.kept < 0 ? !sheet.flap || onlyDoubles : sheet.kept;
                }
            }
        }
    }

    bool decideByBorders() {
        for (const int sheet : open_) {
            sheets_[sheet].odd = sheets_[sheet].even = 0;
        }
        for (const BorderEdge& edge : edges_) {
            noteParity(edge);
        }
        bool any = false;
        for (const int each : open_) {
            DoubleSheet& sheet = sheets_[each];
            if (sheet.kept < 0 && sheet.odd + sheet.even > 0) {
                sheet.kept = sheet.odd > sheet.even ? 1 : 0;
                any = true;
            }
        }
        return any;
    }

    /// What an edge tells of its only sheet that is open. An edge with nothing else tells nothing.
    void noteParity(const BorderEdge& edge) {
        const auto isOpen = [&](int sheet) { return sheets_[sheet].kept < 0; };
        if (std::ranges::count_if(edge.sheets, isOpen) != 1 ||
            edge.sheets.size() + edge.singles == 1) {
            return;
        }
        int others = edge.singles;
        for (const int sheet : edge.sheets) {
            others += std::max(sheets_[sheet].kept, 0);
        }
        DoubleSheet& sheet = sheets_[*std::ranges::find_if(edge.sheets, isOpen)];
        (others % 2 == 1 ? sheet.odd : sheet.even) += edge.length;
    }

    /// Of sheets that meet others and an odd number of single triangles one has to stay.
    bool beginWithLargest() {
        int largest = -1;
        for (const int each : open_) {
            const DoubleSheet& sheet = sheets_[each];
            if (sheet.kept < 0 && sheet.meetsOdd &&
                (largest < 0 || sheet.area > sheets_[largest].area)) {
                largest = each;
            }
        }
        if (largest >= 0) {
            sheets_[largest].kept = 1;
        }
        return largest >= 0;
    }

    const TriangleSoup& soup_;
    const std::vector<Copies>& copies_;
    UnionFind sets_;
    std::vector<DoubleSheet> sheets_;  ///< by their lowest copies
    std::vector<BorderEdge> edges_;
    std::vector<int> open_;  ///< the sheets to decide about, ascending
};

/// How many copies stay.
std::size_t numberToKeep(const Copies& copies, bool odd) {
    if (odd) {
        return 1;
    }
    return copies.isFlap() ? 0 : 2;
}

}  // namespace

int dropDoubles(TriangleSoup& soup) {
    const std::vector<Copies> all = copiesIn(soup);
    if (std::ranges::none_of(all, &Copies::isDouble)) {
        return 0;
    }
    DoubleSheets sheets(soup, all);
    std::vector<char> keep(soup.triangles.size(), 1);
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        if (!all[i].isDouble()) {
            continue;
        }
        for (const std::vector<int>* each : {&all[i].up, &all[i].down}) {
            std::ranges::for_each(*each, [&](int t) { keep[t] = 0; });
        }
        const std::vector<int>& most = all[i].most();
        const std::size_t count = numberToKeep(all[i], sheets.keepsOdd(i));
        for (std::size_t k = 0; k < std::min(count, most.size()); ++k) {
            keep[most[k]] = 1;
        }
    }
    return repair::keepTriangles(soup, [&](int t) { return keep[t] != 0; });
}

}  // namespace kerf::app
