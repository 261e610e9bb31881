#include "sim/cut/stroke/rung_parts.h"

#include "sim/base/containers.h"
#include "sim/cut/blade.h"

namespace kerf::cut {

namespace {

// Shares of h.
constexpr double kBehind = 0.05;       // the blade counts as behind the rung from there on
constexpr double kLeastSpan = 0.45;    // from an end that stays to an inner node that goes
constexpr double kLeastAirEdge = 0.2;  // shorter ones cross an older slit, where no part ends
constexpr double kFromVertex = 0.1;    // from a mesh vertex to the end of a part in the air
// Of what the blade has to be ahead somewhere: an inner node goes.
constexpr double kLeastOfInner = 0.5;
// A front that moves along with the blade slips past it in any direction; from so much way on
// (share of h, on average) the direction is that of the cut.
constexpr double kLeastWay = 0.25;

/// The direction in which the blade goes on, across it.
Vec3 forwards(const Blade& blade, const Vec3& heading) {
    return across(blade, heading).stableNormalized();
}

std::vector<double> progress(const Blade& blade, const Vec3& heading,
                             const std::vector<RungNode>& rung) {
    const Vec3 direction = forwards(blade, heading);
    return mapped(rung, [&](const RungNode& node) {
        return (pointOn(blade, node.s) - node.position).dot(direction);
    });
}

class Parts {
  public:
    Parts(const Blade& blade, double h, double least, const Vec3& heading,
          const std::vector<RungNode>& rung)
        : blade_(blade),
          h_(h),
          least_(least),
          rung_(rung),
          ahead_(progress(blade, heading, rung)) {}

    std::vector<RungPart> run() const {
        std::vector<RungPart> parts;
        for (int i = 0; i < sizeOf(rung_);) {
            if (!goes(i)) {
                ++i;
                continue;
            }
            int last = i;
            while (last + 1 < sizeOf(rung_) && goes(last + 1)) {
                ++last;
            }
            if (auto part = partOf(i, last)) {
                parts.push_back(std::move(*part));
            }
            i = last + 1;
        }
        return parts;
    }

  private:
    /// Where a part ends.
    struct End {
        int node = -1;                       ///< the last one of the old rung in the part
        std::optional<RungNode> inAir = {};  ///< beyond it, where the part ends in the air
        bool held = false;
    };

    bool isInner(int i) const { return i > 0 && rung_[i - 1].attached && rung_[i].attached; }
    bool goes(int i) const {
        return isInner(i) ? ahead_[i] >= kLeastOfInner * least_ : ahead_[i] > 0;
    }
    bool isLongAirEdge(int i, int j) const {
        return !rung_[std::min(i, j)].attached &&
               (rung_[i].position - rung_[j].position).norm() >= kLeastAirEdge * h_;
    }

    // Of the nodes that go, `outmost` and those `inwards` of it up to `inmost`.
    std::optional<End> endAt(int outmost, int inwards, int inmost) const {
        const int beyond = outmost - inwards;
        if (beyond < 0 || beyond >= sizeOf(rung_)) {
            return End{outmost};
        }
        for (int k = beyond; k != inmost; k += inwards) {
            const int next = k + inwards;
            if (isInner(k)) {
                return End{k, std::nullopt, true};
            }
            if (isLongAirEdge(k, next)) {
                return End{next, pointInAir(next, k, k == beyond), true};
            }
        }
        return std::nullopt;
    }

    /// Between a node that goes and its neighbour: where the blade crosses the old rung, or in the
    /// middle; not beside a mesh vertex.
    RungNode pointInAir(int inner, int outer, bool atCrossing) const {
        const RungNode& from = rung_[inner];
        const RungNode& to = rung_[outer];
        const double room = kFromVertex * h_ / (to.position - from.position).norm();
        double t = atCrossing ? ahead_[inner] / (ahead_[inner] - ahead_[outer]) : 0.5;
        t = std::min(t, to.vertex >= 0 ? 1 - room : 1.0);
        t = std::max(t, from.vertex >= 0 ? room : 0.0);
        return {from.position + (to.position - from.position) * t, from.s + (to.s - from.s) * t, -1,
                false};
    }

    std::optional<RungPart> partOf(int first, int last) const {
        const auto a = endAt(first, 1, last);
        const auto b = endAt(last, -1, first);
        const double most = *std::max_element(ahead_.begin() + first, ahead_.begin() + last + 1);
        if (!a || !b || b->node < a->node || most < least_) {
            return std::nullopt;
        }
        RungPart part{{rung_.begin() + a->node, rung_.begin() + b->node + 1},
                      {0, 1, a->held, b->held},
                      a->node,
                      b->node - a->node + 1,
                      a->inAir ? 1 : 0};
        part.rung.back().attached = false;
        if (a->inAir) {
            part.rung.insert(part.rung.begin(), *a->inAir);
        }
        if (b->inAir) {
            part.rung.push_back(*b->inAir);
        }
        part.span.from = a->held ? part.rung.front().s : 0;
        part.span.to = b->held ? part.rung.back().s : 1;
        const bool heldInFront = (a->held && !a->inAir) || (b->held && !b->inAir);
        return heldInFront && !hasRoom(part) ? std::nullopt : std::optional(part);
    }

    /// An inner node that is not too near to its ends.
    bool hasRoom(const RungPart& part) const {
        const double spacing = kLeastSpan * h_ / lengthOf(blade_);
        for (int i = 1; i + 1 < sizeOf(part.rung); ++i) {
            const RungNode& node = part.rung[i];
            if (node.attached && part.rung[i - 1].attached && node.s - part.span.from > spacing &&
                part.span.to - node.s > spacing) {
                return true;
            }
        }
        return false;
    }

    const Blade& blade_;
    double h_;
    double least_;
    const std::vector<RungNode>& rung_;
    std::vector<double> ahead_;
};

}  // namespace

bool isPartlyBehind(const Blade& blade, double h, const Vec3& heading,
                    const std::vector<RungNode>& rung) {
    if (heading.isZero(0)) {
        return false;
    }
    const std::vector<double> ahead = progress(blade, heading, rung);
    return std::ranges::any_of(ahead, [h](double a) { return a < -kBehind * h; });
}

std::vector<RungPart> partsAhead(const Blade& blade, double h, double least, const Vec3& heading,
                                 const std::vector<RungNode>& rung) {
    return Parts(blade, h, least, heading, rung).run();
}

std::vector<RungPart> partsInAir(const Blade& blade, double h, const std::vector<RungNode>& rung) {
    const Vec3 ofA = blade.a - rung.front().position;
    const Vec3 ofB = blade.b - rung.back().position;
    const Vec3 heading = ofA.norm() > ofB.norm() ? ofA : ofB;
    if (!isPartlyBehind(blade, h, heading, rung)) {
        return {};
    }
    std::vector<RungPart> parts = Parts(blade, h, 0, heading, rung).run();
    for (RungPart& part : Parts(blade, h, 0, -heading, rung).run()) {
        parts.push_back(std::move(part));
    }
    std::ranges::sort(parts, {}, &RungPart::first);
    return parts;
}

std::vector<RungNode> replaced(const std::vector<RungNode>& rung, const RungPart& part,
                               const std::vector<RungNode>& next) {
    const auto first = rung.begin() + part.first;
    const auto behind = first + part.count;
    std::vector<RungNode> result(rung.begin(), first);
    result.insert(result.end(), next.begin(), next.end());
    result.back().attached = (behind - 1)->attached;
    result.insert(result.end(), behind, rung.end());
    const auto repeated = [](const RungNode& p, const RungNode& q) {
        return p.vertex < 0 && q.vertex < 0 && p.position == q.position;
    };
    result.erase(std::unique(result.begin(), result.end(), repeated), result.end());
    return result;
}

std::vector<RungNode> stayingFront(const std::vector<RungNode>& rung, const RungPart& part) {
    const auto first = rung.begin() + part.first;
    std::vector<RungNode> result(rung.begin(), first + 1);
    result.back().attached = false;
    result.insert(result.end(), first + part.count - 1, rung.end());
    return result;
}

Vec3 advanceOf(const Blade& blade, double h, const std::vector<RungNode>& from,
               const std::vector<RungNode>& next) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    std::size_t i = 0;
    for (const RungNode& node : next) {
        if (node.vertex < 0) {
            continue;
        }
        while (i + 2 < from.size() && from[i + 1].s < node.s) {
            ++i;
        }
        const RungNode& p = from[i];
        const RungNode& q = from[i + 1];
        const double t = std::clamp((node.s - p.s) / (q.s - p.s), 0.0, 1.0);
        sum += pointOn(blade, node.s) - p.position - t * (q.position - p.position);
        ++count;
    }
    return sum.norm() > kLeastWay * h * count ? sum : Vec3(Vec3::Zero());
}

}  // namespace kerf::cut
