#include "sim/cut/plan/strip/new_rung.h"

#include "sim/cut/blade.h"
#include "sim/cut/exact/jitter.h"

namespace kerf::cut {

namespace {

// Of the edge length there, and of what the length wanted is more: nearer nodes go.
constexpr double kNewRungSpacing = 0.45;
constexpr double kNewRungSpacingInside = 0.75;
// Shares of h.
constexpr double kPinnedDistance = 0.05;
// A blade that has not gone on by this share tells no plane.
constexpr double kLeastWay = 0.01;
constexpr double kOffsetTurn = 0.3;  // of the offset: how much it differs between A and B

// Between two ends that stay, the new rung must leave the old one somewhere.
double middleOfFront(const StepInput& in, const Strip& strip) {
    double first = in.span.to;
    double last = in.span.from;
    for (int i = 0; i + 1 < strip.oldCount; ++i) {
        if (strip.nodes[i].attached) {
            first = std::min(first, strip.nodes[i].s);
            last = std::max(last, strip.nodes[i + 1].s);
        }
    }
    return first < last ? 0.5 * (first + last) : 0.5 * (in.span.from + in.span.to);
}

/// A chain of front edges, by its first and its last node.
struct Chain {
    int first;
    int last;
};

/// Those that end at the skin, not at an end of the rung.
std::vector<Chain> chainsInside(const Strip& strip) {
    std::vector<Chain> chains;
    for (int i = 1; i + 1 < strip.oldCount; ++i) {
        if (!strip.attachedBefore(i) && strip.nodes[i].attached) {
            int last = i + 1;
            while (last < strip.oldCount && strip.nodes[last].attached) {
                ++last;
            }
            if (last + 1 < strip.oldCount) {
                chains.push_back({i, last});
            }
        }
    }
    return chains;
}

/// Whether a triangle between the front edge from node `edge` on and the blade at s would lie on
/// the walls behind that edge.
bool foldsBack(const StepInput& in, const Strip& strip, int edge, double s) {
    const StripNode& p = strip.nodes[edge];
    const StripNode& q = strip.nodes[edge + 1];
    const bool stays = s == in.span.from && in.span.holdsFrom;
    const Vec3 apex = stays ? strip.nodes.front().position : pointOn(in.blade, s);
    const Vec3 along = (q.position - p.position).stableNormalized();
    const Vec3 ahead = pointOn(in.blade, 0.5 * (p.s + q.s)) - 0.5 * (p.position + q.position);
    return (apex - p.position).dot(ahead - along * along.dot(ahead)) < 0;
}

// A short front leans as it likes: what joins it to the far end of the blade alone may fold back
// onto its walls. A point ahead of its middle keeps the strip before it.
void stayAheadOfShortFronts(const StepInput& in, const Strip& strip,
                            std::vector<double>& parameters) {
    for (const Chain& chain : chainsInside(strip)) {
        const double first = strip.nodes[chain.first].s;
        const double last = strip.nodes[chain.last].s;
        const auto behind = std::ranges::upper_bound(parameters, last);
        if (behind == parameters.begin() || behind == parameters.end() || *(behind - 1) >= first) {
            continue;
        }
        bool folds = false;
        for (int i = chain.first; i < chain.last; ++i) {
            folds |= foldsBack(in, strip, i, *(behind - 1));
        }
        if (folds) {
            parameters.insert(behind, 0.5 * (first + last));
        }
    }
}

bool isInterior(const Strip& strip, int i) {
    const StripNode& node = strip.nodes[i];
    return i > 0 && i + 1 < strip.oldCount && node.attached && strip.attachedBefore(i) &&
           sizeOf(node.vertices) == 1;
}

/// Where R1 may have a point for interior node i of the front: ahead of it. Where edges grow,
/// between it and the next one, so that rows of triangles interlock.
double parameterAhead(const StepInput& in, const Strip& strip, int i) {
    const bool between = in.grading.isOn() && isInterior(strip, i + 1);
    return between ? 0.5 * (strip.nodes[i].s + strip.nodes[i + 1].s) : strip.nodes[i].s;
}

// R1 has a point above every interior front node, never above a surface entry: for a straight
// stroke that one would lie exactly in the surface.
std::vector<double> newRungParameters(const StepInput& in, const Strip& strip,
                                      const std::vector<double>& skipped) {
    std::vector<double> result{in.span.from};
    for (int i = 1; i < strip.oldCount - 1; ++i) {
        if (!isInterior(strip, i)) {
            continue;
        }
        const double s = parameterAhead(in, strip, i);
        if (std::find(skipped.begin(), skipped.end(), s) != skipped.end()) {
            continue;
        }
        const double edge =
            in.edgeLengths.localEdgeLength(in.mesh.restPosition(strip.nodes[i].vertices.front()));
        const double more = strip.spacing.at(s, edge) - edge;
        const double spacing =
            (kNewRungSpacing * edge + kNewRungSpacingInside * more) / lengthOf(in.blade);
        if (s - result.back() > spacing && in.span.to - s > spacing) {
            result.push_back(s);
        }
    }
    if (result.size() == 1 && in.span.holdsFrom && in.span.holdsTo) {
        result.push_back(middleOfFront(in, strip));
    }
    result.push_back(in.span.to);
    stayAheadOfShortFronts(in, strip, result);
    return result;
}

bool isPinned(const StepInput& in, const Strip& strip, const Vec3& bladeEnd, int oldEnd) {
    return (bladeEnd - strip.nodes[oldEnd].position).norm() <
           kPinnedDistance * std::min(in.h, strip.height);
}

/// Where the old rung is at a parameter of the blade.
Vec3 oldRungAt(const Strip& strip, double s) {
    int i = 1;
    while (i + 1 < strip.oldCount && strip.nodes[i].s < s) {
        ++i;
    }
    const StripNode& p = strip.nodes[i - 1];
    const StripNode& q = strip.nodes[i];
    const double share = q.s > p.s ? std::clamp((s - p.s) / (q.s - p.s), 0.0, 1.0) : 0;
    return p.position + (q.position - p.position) * share;
}

/// The displacement of the blade at parameter s, which is one for a whole transit [m]. One that
/// stays in its plane goes so far on, and hardly aside: nobody can measure that. Not back: what it
/// swept in the air was swept as far as the blade is.
Vec3 offsetAt(const StepInput& in, const Strip& strip, double s) {
    Vec3 offset = bladeOffset(in.offset * in.h, in.attempt.offsetScale, in.seed, in.transit, s);
    if (!in.attempt.staysInPlane) {
        return offset;
    }
    const Vec3 ahead = across(in.blade, pointOn(in.blade, s) - oldRungAt(strip, s));
    const Vec3 aside = offset * std::min(1.0, kLeastOffset * in.h / offset.norm());
    return ahead.norm() < kLeastWay * in.h
               ? aside
               : Vec3(aside + ahead * (std::fabs(ahead.dot(offset)) / ahead.squaredNorm()));
}

}  // namespace

Vec3 bladeOffset(double length, double scale, std::uint64_t seed, int transit, double s) {
    // The transit is part of the seed: with equal offsets, strokes through one point and a blade
    // that comes back the same way would meet the older slits exactly.
    Jitter jitter(seed * 977 + static_cast<std::uint64_t>(transit) * 131 +
                  static_cast<std::uint64_t>(scale));
    const Vec3 atA = jitter.direction();
    const Vec3 turn = jitter.direction() * kOffsetTurn;
    return (atA + turn * s) * (length * scale);
}

std::vector<std::optional<StripNode>> newRung(const StepInput& in, const Strip& strip,
                                              const std::vector<double>& skipped) {
    const std::vector<double> parameters = newRungParameters(in, strip, skipped);
    const int last = sizeOf(parameters) - 1;
    std::vector<std::optional<StripNode>> nodes(parameters.size());
    for (int j = 0; j <= last; ++j) {
        const double s = parameters[j];
        const Vec3 onBlade = pointOn(in.blade, s);
        const int oldEnd = j == 0 ? 0 : strip.oldCount - 1;
        const bool held = (j == 0 && in.span.holdsFrom) || (j == last && in.span.holdsTo);
        if (!held && !((j == 0 || j == last) && isPinned(in, strip, onBlade, oldEnd))) {
            StripNode& node = nodes[j].emplace();
            node.position = onBlade + offsetAt(in, strip, s);
            node.s = s;
            node.layout = {s * lengthOf(in.blade), strip.height};
        }
    }
    return nodes;
}

}  // namespace kerf::cut
