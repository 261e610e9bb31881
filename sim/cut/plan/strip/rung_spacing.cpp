#include "sim/cut/plan/strip/rung_spacing.h"

#include <algorithm>
#include <cmath>

#include "sim/cut/blade_line.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

namespace {

// Longest edge along the rung over the height of the row: flatter triangles are badly shaped.
constexpr double kFlattest = 2;
constexpr double kNoFront = 1e30;  // [m]

/// Distances of the nodes along the blade to the nearer end of their chain of front edges.
std::vector<double> distancesFromRim(const std::vector<StripNode>& rung, double bladeLength) {
    std::vector<double> distances(rung.size(), 0);
    bool hasFront = false;
    for (int i = 0; i < sizeOf(rung); ++i) {
        int last = i;
        while (last + 1 < sizeOf(rung) && rung[last].attached) {
            ++last;
        }
        hasFront |= last > i;
        for (int k = i; k <= last; ++k) {
            distances[k] = bladeLength * std::min(rung[k].s - rung[i].s, rung[last].s - rung[k].s);
        }
        i = last;
    }
    return hasFront ? distances : std::vector<double>(rung.size(), kNoFront);
}

}  // namespace

RungSpacing::RungSpacing(const StepInput& in, const std::vector<StripNode>& oldRung)
    : grading_(in.grading) {
    if (!grading_.isOn()) {
        return;
    }
    const std::vector<double> fromRim = distancesFromRim(oldRung, lengthOf(in.blade));
    for (int i = 0; i < sizeOf(oldRung); ++i) {
        const StripNode& node = oldRung[i];
        const double height = across(in.blade, node.position - in.blade.a).norm();
        places_.push_back({node.s, fromRim[i], height});
    }
}

double RungSpacing::at(double s, double edge) const {
    if (places_.size() < 2) {
        return edge;
    }
    const auto next = std::clamp(std::ranges::lower_bound(places_, s, {}, &Place::s),
                                 places_.begin() + 1, places_.end() - 1);
    const Place& p = *(next - 1);
    const Place& q = *next;
    const double share = std::clamp((s - p.s) / (q.s - p.s), 0.0, 1.0);
    const double row = std::lerp(p.height, q.height, share);
    return std::min(grading_.lengthAt(edge, std::lerp(p.fromRim, q.fromRim, share)),
                    std::max(edge, kFlattest * row));
}

}  // namespace kerf::cut
