#include "sim/cut/plan/strip/flush.h"

#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

// A vertex this near to the strip's plane lies in it: shares of h, and of the body's diagonal,
// since coordinates are floats.
constexpr double kFlush = 4e-6;
constexpr double kRounding = 0x1p-23;
// So many times that it is seen beside the strip then; and where faces of both sides meet.
constexpr double kAside = 8;
constexpr double kAsideInConflict = 2e-3;
// A triangle of the strip that is not as high as this share of h tells no plane.
constexpr double kLeastHeight = 1e-3;

double roundingOf(const StepInput& in) {
    const double size = in.body.empty() ? in.h : in.body.diagonal();
    return kFlush * in.h + kRounding * size;
}

class Flush {
  public:
    Flush(const StepInput& in, const Strip& strip, PredicatePositions& positions)
        : in_(in), mesh_(in.mesh), strip_(strip), positions_(positions), rounding_(roundingOf(in)) {
        for (const StripNode& node : strip.nodes) {
            onRung_.insert(node.vertices.begin(), node.vertices.end());
        }
    }

    /// All vertices are looked at before one is pinned.
    void run() {
        for (const Triangle& t : strip_.triangles) {
            lookAround({strip_.nodes[t[0]].position, strip_.nodes[t[1]].position,
                        strip_.nodes[t[2]].position});
        }
        for (const auto& [v, way] : ways_) {
            positions_.pinAside(v, way);
        }
    }

  private:
    void lookAround(const Corners& at) {
        const Vec3 normal = areaNormal(at);
        height_ = normal.norm() / longestEdge(at);
        if (!(height_ >= kLeastHeight * in_.h)) {
            return;
        }
        origin_ = at[0];
        normal_ = normal.normalized();
        for (const int t : in_.broadPhase.query(at[0], at[1], at[2], toleranceAt(at[0]))) {
            for (const int v : mesh_.triangle(t)) {
                if (v < in_.firstVertexOfTransit && onRung_.count(v) == 0 && ways_.count(v) == 0 &&
                    isFlush(v)) {
                    look(v);
                }
            }
        }
    }

    /// What is rounded tilts the strip: far from it more counts as flush.
    double toleranceAt(const Vec3& p) const {
        return std::max(1.0, (p - origin_).norm() / height_) * rounding_;
    }

    double distanceOf(int v) const { return normal_.dot(positions_.at(v) - origin_); }
    bool isFlush(int v) const { return std::fabs(distanceOf(v)) <= toleranceAt(mesh_.position(v)); }
    bool isFlushFace(int t) const {
        return std::ranges::all_of(mesh_.triangle(t), [&](int v) { return isFlush(v); });
    }
    bool looksUp(int t) const {
        const auto& [a, b, c] = mesh_.triangle(t);
        return normal_.dot(areaNormal(positions_.at(a), positions_.at(b), positions_.at(c))) > 0;
    }

    /// Whether an older slit ends in v, which has no copies then.
    bool isTip(int v) const {
        bool isWall = false;
        mesh_.forEachOutgoing(v, [&](int h) { isWall |= mesh_.kind(h / 3) == SurfaceKind::wall; });
        return isWall;
    }

    void look(int v) {
        auto known = in_.flushSides.find(v);
        if (known == in_.flushSides.end()) {
            if (mesh_.copyGroup(v) >= 0) {
                requireOneWay(mesh_.copiesOfGroup(mesh_.copyGroup(v)));
            } else if (isTip(v)) {
                throw StepFailure{"the blade meets the end of an older slit"};
            }
            known = in_.flushSides.emplace(v, sideOf(v) * normal_).first;
        }
        if (const double side = known->second.dot(normal_); side != 0) {
            ways_[v] = (side * rounding_ - distanceOf(v)) * normal_;
        }
    }

    /// What lies around a vertex: flush faces that look up or down, vertices below or above the
    /// strip, vertices that the stroke made.
    struct Around {
        bool up = false;
        bool down = false;
        bool below = false;
        bool above = false;
        bool isCut = false;
    };

    Around lookedAround(int v) const {
        Around around;
        mesh_.forEachOutgoing(v, [&](int h) {
            const int p = mesh_.target(h);
            around.isCut |= p >= in_.firstVertexOfTransit;
            if (isFlushFace(h / 3)) {
                (looksUp(h / 3) ? around.up : around.down) = true;
            }
            if (!isFlush(p)) {
                (distanceOf(p) < 0 ? around.below : around.above) = true;
            }
        });
        return around;
    }

    /// Where the strip crosses one side of an older slit and only touches the other, no sides keep
    /// the walls mirrored.
    void requireOneWay(const std::vector<int>& copies) const {
        int crossed = 0;
        for (const int v : copies) {
            const Around around = lookedAround(v);
            crossed += around.below && around.above ? 1 : 0;
        }
        if (crossed > 0 && crossed < static_cast<int>(copies.size())) {
            throw StepFailure{"the blade runs along a line in which older slits meet"};
        }
    }

    /// In units of rounding, positive on the side to which the normal points; 0 where the vertex
    /// stays, since the stroke has cut beside it.
    double sideOf(int v) const {
        const Around around = lookedAround(v);
        if (around.isCut) {
            return 0;
        }
        if (around.up && around.down) {
            return kAsideInConflict * sideOfConflict(v);
        }
        return around.up || (!around.down && around.below && !around.above) ? -kAside : kAside;
    }

    /// Where faces of both sides meet: the side on which fewer edges of a face have both ends where
    /// it does not belong. Along these a bar of no thickness would join what is parted.
    int sideOfConflict(int v) const {
        int badAbove = 0;
        int badBelow = 0;
        mesh_.forEachOutgoing(v, [&](int h) {
            const auto known = in_.flushSides.find(mesh_.target(h));
            if (known == in_.flushSides.end() || !isFlush(mesh_.target(h))) {
                return;
            }
            const double side = known->second.dot(normal_);
            for (const int t : {h / 3, mesh_.twin(h) / 3}) {
                badAbove += isFlushFace(t) && looksUp(t) && side > 0 ? 1 : 0;
                badBelow += isFlushFace(t) && !looksUp(t) && side < 0 ? 1 : 0;
            }
        });
        return badAbove > badBelow ? -1 : 1;
    }

    const StepInput& in_;
    const SurfaceMesh& mesh_;
    const Strip& strip_;
    PredicatePositions& positions_;
    double rounding_;  ///< what is nearer to the strip may lie in it [m]
    std::set<int> onRung_;
    std::map<int, Vec3> ways_;    ///< by vertex, from where it is seen otherwise [m]
    Vec3 origin_ = Vec3::Zero();  ///< of the triangle in hand
    Vec3 normal_ = Vec3::Zero();  ///< the same, of length 1
    double height_ = 0;           ///< the same, over its longest edge [m]
};

}  // namespace

void seeFlushAside(const StepInput& in, const Strip& strip, PredicatePositions& positions) {
    Flush(in, strip, positions).run();
}

}  // namespace kerf::cut
