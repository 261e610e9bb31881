#include "app/editor/steps/scene_link.h"

#include "app/scene/document/editor_document.h"
#include "app/scene/document/scene_body.h"
#include "sim/base/text.h"
#include "sim/run/simulation.h"

namespace kerf::app {

namespace {

constexpr int kBodies = 25;             // a second, as by `kerf replay --serve`
constexpr double kLedPause = 0.016;     // [s]
constexpr double kAlonePause = 0.1;     // without a client [s]
constexpr double kMeasuredShare = 0.5;  // where along the blade its way is measured

}  // namespace

void SceneLink::start(EditorScene& scene) {
    server_.emplace(readLinkAddress(address_).value());
    begin(scene);
}

void SceneLink::stop() {
    blade_.reset();
    server_.reset();
    leads_ = false;
}

void SceneLink::begin(EditorScene& scene) {
    leads_ = false;
    if (server_) {
        const Session& session = scene.document().session;
        scene.simulation().feelBlade(true);
        const double diagonal = scene.rest().bounds().diagonal();
        blade_.emplace(*server_, bladeLengthOf(session).value_or(diagonal), session.origin,
                       kBodies);
    }
}

bool SceneLink::follow(EditorScene& scene) {
    if (!server_) {
        return false;
    }
    const std::size_t before = server_->clients();
    std::vector<Command> commands = blade_->await(0);
    if (blade_->isOver()) {
        std::ranges::copy(blade_->lift(), std::back_inserter(commands));
    }
    std::ranges::for_each(commands, [&](const Command& c) { lead(c, scene); });
    blade_->tell(scene.simulation());
    return server_->clients() != before;
}

/// The pointer keeps the blade that it holds: whoever puts it down first leads it.
void SceneLink::lead(const Command& command, EditorScene& scene) {
    BladeStroke& stroke = scene.stroke();
    const auto* move = std::get_if<MoveBlade>(&command);
    const bool leading = leads({&scene, false});
    if (leading && move == nullptr) {
        stroke.end();
    } else if (leading) {
        stroke.moveTo(move->blade);
    } else if (move != nullptr && !stroke.drawing()) {
        stroke.begin(move->blade, {kMeasuredShare, maxStrokeStep(scene.simulation().bounds())});
        leads_ = true;
    }
}

bool SceneLink::leads(const BusyScene& scene) {
    leads_ = leads_ && scene && scene.stroke().drawing();
    return leads_;
}

std::string SceneLink::state() const {
    return server_ ? "Link: " + counted(server_->clients(), "client", "clients") + " on " +
                         server_->address()
                   : "";
}

double SceneLink::pause() const {
    return server_ && server_->clients() > 0 ? kLedPause : kAlonePause;
}

}  // namespace kerf::app
