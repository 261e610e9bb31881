#include "tests/support/reference/reference_boxes.h"

#include <Eigen/Geometry>

#include "shaders/shared/contact_records.h"

namespace kerf {

namespace {

// As the kernel has them.
constexpr double kSkinDeep = 0.1;   // of the depth of touches
constexpr double kParallel = 1e-3;  // sine of the angle between edges

Vec3 cornerOf(const Vec3& half, int index) {
    const auto side = [index](int axis) { return ((index >> axis) & 1) != 0 ? 1.0 : -1.0; };
    return half.cwiseProduct(Vec3(side(0), side(1), side(2)));
}

/// By how much a triangle and a box overlap least, over all axes that may part them; negative where
/// they are apart.
double overlapOf(const std::array<Vec3, 3>& at, const Vec3& half) {
    std::vector<Vec3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(),
                           (at[1] - at[0]).cross(at[2] - at[0])};
    for (int i = 0; i < 3; ++i) {
        const Vec3 edge = at[(i + 1) % 3] - at[i];
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 across = Vec3::Unit(axis).cross(edge);
            if (across.norm() > kParallel * edge.norm()) {
                axes.push_back(across);
            }
        }
    }
    double least = 1e300;
    for (const Vec3& axis : axes) {
        const Vec3 n = axis.normalized();
        const auto [low, high] = std::minmax({n.dot(at[0]), n.dot(at[1]), n.dot(at[2])});
        least = std::min(least, n.cwiseAbs().dot(half) - std::max(low, -high));
    }
    return least;
}

}  // namespace

ReferenceBoxes::ReferenceBoxes(const BodyModel& model, std::vector<StaticBox> boxes,
                               const ContactSettings& settings, const TouchDistances& distances,
                               std::vector<double> inverseMass)
    : model_(model),
      boxes_(std::move(boxes)),
      settings_(settings),
      distances_(distances),
      inverseMass_(std::move(inverseMass)) {}

bool ReferenceBoxes::isNear(const Corners& corners, const Vec3& half) const {
    Bounds around;
    for (int k = 0; k < 3; ++k) {
        around.add(corners.at[k]);
        around.add(corners.at[k] + corners.way[k]);
    }
    const Vec3 reach = half + Vec3::Constant(distances_.thickness);
    return (around.low.array() < reach.array()).all() &&
           (around.high.array() > -reach.array()).all();
}

std::optional<ReferenceBoxes::Touch> ReferenceBoxes::atCorner(const Corners& corners,
                                                              const Vec3& normal,
                                                              const Vec3& corner) const {
    const double before = normal.dot(corners.at[0] - corner);
    if (normal.dot(corner) <= 0 || before < -distances_.depth) {
        return std::nullopt;
    }
    std::array<Vec3, 3> end;
    for (int k = 0; k < 3; ++k) {
        end[k] = corners.at[k] + corners.way[k];
    }
    const Vec3 area = (end[1] - end[0]).cross(end[2] - end[0]);
    Vec3 weights;
    for (int k = 0; k < 3; ++k) {
        const Vec3& next = end[(k + 1) % 3];
        weights[k] =
            (next - corner).cross(end[(k + 2) % 3] - corner).dot(area) / area.squaredNorm();
    }
    if (weights.minCoeff() < 0) {
        return std::nullopt;
    }
    return Touch{normal, before, Vec3::Zero(), weights};
}

std::optional<ReferenceBoxes::Touch> ReferenceBoxes::atEdge(const Corners& corners,
                                                            const Vec3& normal, int side, int axis,
                                                            const Vec3& start) const {
    const int next = (side + 1) % 3;
    const Vec3 along = -2 * start[axis] * Vec3::Unit(axis);
    const Vec3 edge = corners.at[next] - corners.at[side];
    Vec3 across = edge.cross(along);
    if (across.norm() < kParallel * edge.norm() * along.norm()) {
        return std::nullopt;
    }
    Vec3 outward = start;
    outward[axis] = 0;
    across = across.normalized() * (across.dot(outward) < 0 ? -1 : 1);
    const double before = across.dot(corners.at[side] - start);
    if (across.cwiseProduct(outward).minCoeff() < 0 || across.dot(normal) <= 0 ||
        before < -distances_.depth) {
        return std::nullopt;
    }
    // Where the lines come nearest at X + d.
    const Vec3 from = corners.at[side] + corners.way[side];
    const Vec3 line = corners.at[next] + corners.way[next] - from;
    const double mixed = line.dot(along);
    const double scale = line.squaredNorm() * along.squaredNorm() - mixed * mixed;
    const Vec3 apart = start - from;
    const double s = (apart.dot(line) * along.squaredNorm() - apart.dot(along) * mixed) / scale;
    const double t = (apart.dot(line) * mixed - apart.dot(along) * line.squaredNorm()) / scale;
    if (std::min(s, t) < 0 || std::max(s, t) > 1) {
        return std::nullopt;
    }
    Vec3 weights = Vec3::Zero();
    weights[side] = 1 - s;
    weights[next] = s;
    return Touch{across, before, Vec3::Zero(), weights};
}

std::optional<ReferenceBoxes::Touch> ReferenceBoxes::passingThrough(const Corners& corners,
                                                                    const Vec3& normal,
                                                                    const Vec3& half) const {
    const double middle = normal.dot(corners.at[0]);
    const double before = middle - normal.cwiseAbs().dot(half);
    const auto isBeside = [&](const Vec3& p) {
        return (p.cwiseAbs() - half).maxCoeff() > -kSkinDeep * distances_.depth;
    };
    if (middle <= 0 || before >= -distances_.depth || !std::ranges::all_of(corners.at, isBeside) ||
        overlapOf(corners.at, half) <= kSkinDeep * distances_.depth) {
        return std::nullopt;
    }
    return Touch{normal, before, Vec3::Zero(), Vec3::Constant(1.0 / 3), true};
}

std::optional<ReferenceBoxes::Touch> ReferenceBoxes::mostUrgent(const StaticBox& box,
                                                                const Corners& corners,
                                                                const Ids& ids) const {
    const Vec3 half = 0.5 * box.size;
    if (!isNear(corners, half)) {
        return std::nullopt;
    }
    const Vec3 normal =
        (corners.at[2] - corners.at[0]).cross(corners.at[1] - corners.at[0]).normalized();
    std::optional<Touch> best;
    const auto consider = [&](std::optional<Touch> touch) {
        if (!touch) {
            return;
        }
        touch->slip = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            touch->slip += touch->weights[k] * corners.way[k];
        }
        if (touch->gap() < (best ? best->gap() : distances_.thickness)) {
            best = touch;
        }
    };
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p = cornerOf(half, corner);
        consider(atCorner(corners, normal, p));
        for (int side = 0; side < 3; ++side) {
            for (int axis = 0; axis < 3 && ids[side] <= ids[(side + 1) % 3]; ++axis) {
                if (p[axis] < 0) {
                    consider(atEdge(corners, normal, side, axis, p));
                }
            }
        }
    }
    consider(passingThrough(corners, normal, half));
    return best;
}

ReferenceBoxes::Answer ReferenceBoxes::answerTo(const Touch& touch, const StaticBox& box,
                                                const Ids& ids) const {
    const Vec3& n = touch.normal;
    const double least = std::min(distances_.thickness - touch.before, 0.0);
    const double approach = std::max(least - n.dot(touch.slip), 0.0);
    const double reached = touch.gap() + approach;
    const double lack =
        std::max(-reached, shared::kThicknessRate * (distances_.thickness - reached));
    const double push = std::clamp(lack, 0.0, settings_.liftSpeed * settings_.substep);
    const Vec3 along = touch.slip - n.dot(touch.slip) * n;
    const double held = std::min(along.norm(), settings_.friction * approach);
    const Vec3 impulse = approach * n - held * along.stableNormalized();
    return {ids, touch.weights, box.axes() * impulse, box.axes() * (push * n), touch.passes};
}

/// Of the box whose touch leaves the smallest gap.
std::optional<ReferenceBoxes::Answer> ReferenceBoxes::answerOf(const Ids& ids,
                                                               const ReferenceState& state) const {
    std::optional<Answer> answer;
    double least = distances_.thickness;
    for (const StaticBox& box : boxes_) {
        const Eigen::Matrix3d toBox = box.axes().transpose();
        Corners corners;
        for (int k = 0; k < 3; ++k) {
            corners.at[k] = toBox * (state.positions[ids[k]] - box.center);
            corners.way[k] = toBox * state.displacements[ids[k]];
        }
        const std::optional<Touch> touch = mostUrgent(box, corners, ids);
        if (touch && touch->gap() < least) {
            least = touch->gap();
            answer = answerTo(*touch, box, ids);
        }
    }
    return answer;
}

ReferenceBoxes::Counts ReferenceBoxes::respond(ReferenceState& state) const {
    std::vector<Answer> answers;
    std::vector<double> taken(state.positions.size(), 0.0);
    for (const auto& t : model_.triangles) {
        if (const std::optional<Answer> answer = answerOf({t[0], t[1], t[2]}, state)) {
            answers.push_back(*answer);
            for (int k = 0; k < 3; ++k) {
                taken[answer->ids[k]] += answer->weights[k];
            }
        }
    }
    Counts counts;
    for (const Answer& answer : answers) {
        ++(answer.passes ? counts.passed : counts.touched);
        apply(answer, taken, state);
    }
    return counts;
}

void ReferenceBoxes::apply(const Answer& answer, const std::vector<double>& taken,
                           ReferenceState& state) const {
    double weight = 0;
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t v = answer.ids[k];
        weight += inverseMass_[v] * answer.weights[k] * taken[v];
    }
    for (int k = 0; k < 3 && weight > 0; ++k) {
        const std::uint32_t v = answer.ids[k];
        const double gain = answer.weights[k] * inverseMass_[v] / weight;
        state.displacements[v] += gain * answer.impulse;
        state.positions[v] += gain * answer.push;
    }
}

}  // namespace kerf
