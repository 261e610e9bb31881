#include <spdlog/fmt/fmt.h>

#include "app/editor/editor_state.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/section_pick.h"
#include "app/tools/measure_tool.h"
#include "sim/base/text.h"
#include "ui/state/action_table.h"

namespace kerf::app {
namespace {

using State = Editor::State;

constexpr double kQuietSeconds = 0.5;  // nothing is said of work that is over sooner

/// The world's axes as the view shows them.
ui::ViewAxes axesOf(const render::Camera& camera) {
    const Eigen::Matrix3d turn = camera.view().topLeftCorner<3, 3>().cast<double>();
    return {{turn.col(0), turn.col(1), turn.col(2)}};
}

/// The legend of the colours, with the value under the pointer if the scene is at rest.
ui::FieldLegend fieldLegend(State& s, bool inView) {
    const render::FieldChoice& choice = s.view.display.settings.field;
    ui::FieldLegend legend{choice.field, s.picture.fieldRange(), {}, &render::colorsOf(choice), ""};
    if (legend.field == render::SurfaceField::look || s.view.faulty || s.scene == nullptr ||
        s.scene.underWay()) {
        return legend;
    }
    if (legend.field == render::SurfaceField::thickness) {
        legend.note = s.scene->readout().thickness().note(s.scene->simulation());
    }
    if (inView && s.view.display.settings.apart == 0) {
        if (const auto point = pickVisible(*s.scene, s.view.frame().rayThrough(s.view.pointer),
                                           s.view.display.settings.section)) {
            legend.underPointer = s.picture.fieldAt(*s.scene, *point);
        }
    }
    return legend;
}

ui::WorkState seekWork(const BusyScene& now, int steps) {
    const int target = now.seekTarget();
    return {fmt::format("{}: going to step {}", now.document().name, target),
            fmt::format("Step {} of {}", target - steps, target),
            static_cast<double>(target - steps), static_cast<double>(target)};
}

/// A stroke by its poses; and what else takes long.
ui::WorkState sceneWork(const State& s) {
    const BusyScene now = s.scene.meanwhile();
    const double known = s.clock.secondsPerStep();
    const double perStep = std::max(known, s.scene.seconds());
    if (!now) {
        return {};
    }
    if (const int steps = now.seekSteps(); steps > 0) {
        return seekWork(now, steps);
    }
    const StrokeProgress cut = now.stroke().progress();
    const auto left = static_cast<double>(cut.poses - cut.done);
    if (s.scene.stops && s.scene.underWay() && perStep > kQuietSeconds) {
        return {.title = "Stopping after this step...", .stage = "Please wait", .mayEnd = false};
    }
    if (left * perStep > kQuietSeconds) {
        return {"Cutting", fmt::format("Step {} of {}", cut.done, cut.poses),
                static_cast<double>(cut.done), static_cast<double>(cut.poses)};
    }
    if (s.scene.isAt(SceneWork::change) && s.scene.seconds() > kQuietSeconds) {
        return {.title = "Updating the model", .stage = "Please wait", .mayEnd = false};
    }
    if (s.scene.isAt(SceneWork::steps) && perStep > kQuietSeconds) {
        const bool overdue = s.scene.seconds() >= known;
        return {"Computing",
                overdue ? "A step of this model takes long" : fmt::format("{:.1f} s a step", known),
                s.scene.seconds(), overdue ? 0 : known};
    }
    return {};
}

ui::Hint offerToReload(const std::vector<std::filesystem::path>& changed) {
    const std::string names =
        joined(changed, ", ", [](const auto& f) { return f.filename().string(); });
    const bool one = changed.size() == 1;
    return {
        names + (one ? " has changed on disk. Reload it?" : " have changed on disk. Reload them?"),
        {{ui::ActionId::reloadModels, "Reload"}, {ui::ActionId::cancel, "Ignore"}}};
}

}  // namespace

void Editor::State::describeScene() {
    const ui::PanelModel blank;  // GCC 12 takes parts of a temporary for uninitialized
    panels.told = blank;
    if (scene != nullptr) {
        scene->describe(panels.told);
        sceneHistory.describe(*scene, panels.told.changes);
        if (const std::string& change = sceneHistory.exchanged(); !change.empty()) {
            auto& past = panels.told.session.past;
            past.insert(past.begin(), {0, 0, ui::SessionMark::Kind::scene, change});
        }
    }
    panels.told.help.hint = guide.hint(scene.get(), view, panels.practice.isScored());
    panels.experiments.describe(scene.get(), panels.told);
}

void Editor::State::describe(bool withOverlay) {
    ui::PanelModel& model = panels.model;
    ui::Overlay before = std::move(model.view.overlay);
    if (!scene.underWay()) {
        describeScene();
    }
    panels.describe();
    if (const BusyScene now = scene.meanwhile()) {
        model.transport.playing = now.playing();
        model.transport.seeking = now.seekSteps() > 0;
        model.transport.pulling = now.pulling();
        if (view.display.settings.apart == 0) {
            const bool inView = !panels.interface.ownsPointer();
            model.view.overlay = withOverlay ? view.overlay(inView, now) : std::move(before);
            if (withOverlay) {
                panels.practice.addTo(model.view.overlay, view.frame(), panels.settings.now);
            }
        }
    }
    panels.practice.describe(model.session.practice);
    view.display.describe(scene.meanwhile(), model);
    model.looks.field = fieldLegend(*this, withOverlay && !panels.interface.ownsPointer());
    model.view.axes = axesOf(view.camera.shown());
    model.view.orthographic = view.camera.shown().orthographic;
    model.tools = view.tools.settings();
    model.view.link = link.state();
    model.view.measures = view.tools.get<MeasureTool>().rows();
    model.transport.speed = clock.speed();
    chooser.describe(model);
    materials.describe(model);
    model.help.start.opening = work.opening() != nullptr;
    model.work = work.state();
    if (model.work.title.empty()) {
        model.work = sceneWork(*this);
    }
    if (closing && work.saving() != nullptr) {
        model.work.title = work.saving()->title + " first, then Kerf closes";
    }
    panels.timeLeft.follow(model.work);
    toast.describe(model);
    if (!work.models.changed().empty() && !panels.startOpen) {
        model.help.hint = offerToReload(work.models.changed());
    }
    model.session.unsaved = hasUnsavedWork();
    describeFaults();
}

std::string Editor::State::title() const {
    if (scene == nullptr) {
        return "Kerf";
    }
    const EditorScene* const rests = scene.atRest();
    const std::size_t pieces =
        rests == nullptr ? panels.told.pieces.rows.size() : rests->simulation().report().pieces;
    return "Kerf - " + scene.meanwhile().document().name + " - " +
           counted(pieces, "piece", "pieces");
}

}  // namespace kerf::app
