#include "app/link/blade_link.h"

#include "app/files/export/export_mesh.h"
#include "sim/run/simulation.h"

namespace kerf::app {

namespace {

constexpr std::string_view kTool = "Blade";  // whose poses are taken
constexpr std::string_view kLift = "lift";   // a STRING of that name that ends a stroke
constexpr double kShortest = 1e-6;           // between two poses, as sessions have it [s]

}  // namespace

std::vector<Command> BladeLink::await(double seconds) {
    do {
        server_.exchange(std::max(0.0, seconds - sinceStep_.seconds()),
                         [this](const IgtlMessage& message) { take(message); });
        sinceStep_.restart();
    } while (seconds > 0 && server_.joined() == 0);
    ++steps_;
    std::vector<Command> commands;
    if (std::exchange(lifts_, false)) {
        commands = lift();
    }
    if (const auto pose = std::exchange(newest_, std::nullopt)) {
        commands.push_back(moveTo(*pose));
    }
    return commands;
}

void BladeLink::take(const IgtlMessage& message) {
    if (const auto pose = poseIn(message, kTool)) {
        newest_ = pose;
    } else if (message.device == kTool && textIn(message) == kLift) {
        newest_.reset();
        lifts_ = true;
    }
}

/// Its time is that of the hand, also where steps take longer than what they simulate.
Command BladeLink::moveTo(const IgtlPose& pose) {
    const int since = isDown_ ? std::max(1, steps_) : 1;
    const double seconds = std::max(kShortest, sinceCommand_.restart() / since);
    const Vec3 tip = fromRas(pose.position) / kMillimetres - origin_;
    isDown_ = true;
    steps_ = 0;
    return MoveBlade{{tip, tip + bladeLength_ * fromRas(pose.zAxis)}, seconds};
}

std::vector<Command> BladeLink::lift() {
    if (!std::exchange(isDown_, false)) {
        return {};
    }
    sinceCommand_.restart();
    return {LiftBlade{}};
}

void BladeLink::tell(Simulation& simulation) {
    if (server_.joined() > std::exchange(greeted_, server_.joined())) {
        server_.send({"STATUS", "Kerf", statusOf("ready")});
    }
    if (const auto blade = simulation.comingBlade()) {
        const Vec3 way = toRas(blade->b - blade->a);
        server_.send({"TRANSFORM", "KerfBlade",
                      transformOf({kMillimetres * toRas(blade->a + origin_), way.normalized()})});
    }
    if (const auto& load = simulation.report().bladeLoad) {
        server_.send({"SENSOR", "KerfForce", sensorOf(toRas(load->force))});
    }
    if (server_.clients() > 0 && bodies_ * sinceBody_.seconds() >= 1) {
        sinceBody_.restart();
        server_.send(bodyOf(simulation), true);
    }
}

void BladeLink::tell(const std::string& device, const std::string& text) {
    server_.send({"STRING", device, stringOf(text)});
}

IgtlMessage BladeLink::bodyOf(Simulation& simulation) const {
    const ExportMesh body = gatherMesh(simulation.mesh(), simulation.pieces(), {});
    std::vector<Vec3> points;
    for (const Vec3f& point : body.positions) {
        points.push_back(kMillimetres * toRas(point.cast<double>() + origin_));
    }
    std::vector<Triangle> triangles;
    std::ranges::transform(body.faces, std::back_inserter(triangles), &ExportFace::corners);
    return {"POLYDATA", "KerfBody", polyDataOf(points, triangles)};
}

}  // namespace kerf::app
