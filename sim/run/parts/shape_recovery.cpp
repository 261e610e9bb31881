#include "sim/run/parts/shape_recovery.h"

#include "sim/body/piece_masses.h"

namespace kerf {

namespace {

constexpr double kRate = 6;        // at which the ways to the goal shrink [1/s]
constexpr double kLongest = 1.25;  // for which a piece is drawn [s]
constexpr double kBack = 0.01;     // RMS way, as a share of the radius, at which a piece is back
// What is held weighs so much more where the shape is fitted.
constexpr double kHeldWeight = 1000;

Vec3 noLongerThan(const Vec3& vector, double length) {
    const double now = vector.norm();
    return now > length ? Vec3(vector * (length / now)) : vector;
}

/// What stops vertices on their way back slows a piece down and turns it, but throws it nowhere.
RigidMotion noFasterThan(const RigidMotion& motion, const std::optional<RigidMotion>& before) {
    return before ? RigidMotion{noLongerThan(motion.velocity, before->velocity.norm()),
                                noLongerThan(motion.spin, before->spin.norm())}
                  : motion;
}

/// Lifts a goal out of the floor, on which a piece then lies still.
void putOnFloor(std::span<const FittedVertex> vertices, double floor, RestPose& goal,
                RigidMotion& motion) {
    constexpr double kNear = 1e-3;  // of the radius
    double lowest = std::numeric_limits<double>::max();
    for (const FittedVertex& v : vertices) {
        lowest = std::min(lowest, goal.placeOf(v.rest).y());
    }
    if (lowest < floor + kNear * goal.radius) {
        goal.middle.y() += std::max(floor - lowest, 0.0);
        motion.velocity.y() = std::max(motion.velocity.y(), 0.0);
    }
}

bool isHeld(const ShapeRecovery::Body& body, int vertex) {
    return std::ranges::binary_search(body.held, static_cast<std::uint32_t>(vertex));
}

FittedVertex vertexOf(const ShapeRecovery::Body& body, std::size_t index) {
    const int v = static_cast<int>(index);
    const double weight = unitMass(body.model, index) * (isHeld(body, v) ? kHeldWeight : 1.0);
    return {v, weight, body.mesh.position(v), body.mesh.restPosition(v), body.mesh.velocity(v)};
}

shared::PullRecord ledTo(const RestPose& goal, const RigidMotion& motion, const FittedVertex& v,
                         double timeStep) {
    const Vec3 way = goal.placeOf(v.rest) - v.at;
    const Eigen::AngleAxisd turn(timeStep * motion.spin.norm(), motion.spin.normalized());
    const Vec3 arm = v.at - goal.middle;  // along a tangent of the turn, the piece would grow
    const Vec3 velocity =
        motion.velocity + (turn * arm - arm) / timeStep + std::min(kRate, 1 / timeStep) * way;
    const Vec3f to = (v.at + timeStep * velocity).cast<float>();
    const Vec3f u = velocity.cast<float>();
    const auto vertex = static_cast<std::uint32_t>(v.vertex);
    return {vertex, to.x(), to.y(), to.z(), u.x(), u.y(), u.z(), 1};
}

}  // namespace

int ShapeRecovery::begin(std::span<const double> insideOut) {
    recoveries_.resize(insideOut.size());
    int begun = 0;
    for (std::size_t p = 0; p < recoveries_.size(); ++p) {
        if (insideOut[p] > kMostInsideOut && !recoveries_[p].spent) {
            recoveries_[p] = {.draws = true, .spent = true, .motion = {}};
            ++begun;
        }
    }
    return begun;
}

void ShapeRecovery::allowAgain() {
    for (Recovery& recovery : recoveries_) {
        recovery.spent = recovery.draws;
    }
}

void ShapeRecovery::follow(std::span<const int> source) {
    if (recoveries_.empty()) {
        return;
    }
    const std::vector<Recovery> before = recoveries_;
    recoveries_.assign(source.size(), {});
    for (std::size_t p = 0; p < source.size(); ++p) {
        if (source[p] >= 0 && static_cast<std::size_t>(source[p]) < before.size()) {
            recoveries_[p] = before[source[p]];
        }
    }
}

bool ShapeRecovery::draws() const {
    return std::ranges::any_of(recoveries_, &Recovery::draws);
}

bool ShapeRecovery::draws(int piece) const {
    return static_cast<std::size_t>(piece) < recoveries_.size() && recoveries_[piece].draws;
}

std::vector<shared::PullRecord> ShapeRecovery::advance(const Body& body) {
    std::vector<std::vector<FittedVertex>> pieces(recoveries_.size());
    for (std::size_t v = 0; v < body.model.pieceOfVertex.size(); ++v) {
        if (const int piece = body.model.pieceOfVertex[v]; piece >= 0 && draws(piece)) {
            pieces[piece].push_back(vertexOf(body, v));
        }
    }
    std::vector<shared::PullRecord> records;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        if (recoveries_[p].draws) {
            lead(std::move(pieces[p]), body, recoveries_[p], records);
        }
    }
    return records;
}

void ShapeRecovery::lead(std::vector<FittedVertex> vertices, const Body& body, Recovery& recovery,
                         std::vector<shared::PullRecord>& records) {
    const Params& params = body.params;
    RestPose goal = fitRestPose(vertices);
    RigidMotion motion = noFasterThan(rigidMotionOf(vertices, goal.middle), recovery.motion);
    motion.velocity += params.timeStep * params.gravity;
    if (params.floor) {
        putOnFloor(vertices, *params.floor, goal, motion);
    }
    recovery.motion = motion;
    recovery.time += params.timeStep;
    std::erase_if(vertices, [&](const FittedVertex& v) { return isHeld(body, v.vertex); });
    recovery.draws = recovery.time < kLongest && !vertices.empty() &&
                     rmsWay(goal, vertices) > kBack * fitRestPose(vertices).radius;
    for (std::size_t i = 0; recovery.draws && i < vertices.size(); ++i) {
        records.push_back(ledTo(goal, motion, vertices[i], params.timeStep));
    }
}

}  // namespace kerf
