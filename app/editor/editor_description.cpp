#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <string>

#include "app/editor/editor_state.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/section_pick.h"
#include "app/tools/measure_tool.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

constexpr double kQuietSeconds = 0.5;  // nothing is said of work that is over sooner

/// The world's axes as the view shows them.
ui::ViewAxes axesOf(const render::Camera& camera) {
    const Eigen::Matrix3d turn = camera.view().topLeftCorner<3, 3>().cast<double>();
    return {{turn.col(0), turn.col(1), turn.col(2)}};
}

}  // namespace

void Editor::State::describeScene() {
    const ui::PanelModel blank;  // GCC 12 takes parts of a temporary for uninitialized
    told = blank;
    if (scene != nullptr) {
        scene->describe(told);
        sceneSteps.describe(*scene, told.changes);
    }
    told.help.hint = guide.hint(scene.get(), view);
    experiments.describe(scene.get(), told);
}

void Editor::State::describe(bool withOverlay) {
    ui::PanelModel& model = panels.model;
    ui::Overlay before = std::move(model.view.overlay);
    if (!scene.underWay()) {
        describeScene();
    }
    panels.describe(told);
    if (const BusyScene now = scene.meanwhile()) {
        model.transport.playing = now.playing();
        if (view.display.settings.apart == 0) {
            const bool inView = !panels.interface.ownsPointer();
            model.view.overlay = withOverlay ? view.overlay(inView, now) : std::move(before);
        }
    }
    view.display.describe(scene.meanwhile(), model);
    model.looks.field = fieldLegend(withOverlay && !panels.interface.ownsPointer());
    model.view.axes = axesOf(view.camera.shown());
    model.view.orthographic = view.camera.shown().orthographic;
    model.tools = view.tools.settings();
    model.view.measures = view.tools.get<MeasureTool>().rows();
    model.transport.speed = clock.speed();
    chooser.describe(model);
    materials.describe(model);
    model.work = work.state();
    if (model.work.title.empty()) {
        model.work = sceneWork();
    }
    if (asked) {
        model.question = asked->question;
    }
    toast.describe(model);
    describeFaults();
}

ui::FieldLegend Editor::State::fieldLegend(bool inView) {
    ui::FieldLegend legend{view.display.settings.field.field, picture.fieldRange(), {}, ""};
    if (legend.field == render::SurfaceField::look || faulty || scene == nullptr ||
        scene.underWay()) {
        return legend;
    }
    if (legend.field == render::SurfaceField::thickness) {
        legend.note = scene->readout().thickness().note(scene->simulation());
    }
    if (inView && view.display.settings.apart == 0) {
        if (const auto point = pickVisible(*scene, view.frame().rayThrough(view.pointer),
                                           view.display.settings.section)) {
            legend.underPointer = picture.fieldAt(*scene, *point);
        }
    }
    return legend;
}

/// A stroke by its poses; and what else takes long, which has no end that could be told.
ui::WorkState Editor::State::sceneWork() const {
    const BusyScene now = scene.meanwhile();
    const double perStep = std::max(clock.secondsPerStep(), scene.seconds());
    if (!now) {
        return {};
    }
    const StrokeProgress cut = now.stroke().progress();
    const auto left = static_cast<double>(cut.poses - cut.done);
    if (left * perStep > kQuietSeconds) {
        return {"Cutting", std::to_string(cut.done) + " of " + std::to_string(cut.poses) + " steps",
                left * perStep, static_cast<double>(cut.done) / static_cast<double>(cut.poses)};
    }
    if (scene.isAt(SceneWork::change) && scene.seconds() > kQuietSeconds) {
        return {.title = "Changing the body",
                .stage = "Waiting",
                .seconds = scene.seconds(),
                .mayEnd = false};
    }
    if (scene.isAt(SceneWork::steps) && perStep > kQuietSeconds) {
        return {fmt::format("A step takes {:.1f} s", perStep), "Computing", scene.seconds(),
                std::min(1.0, scene.seconds() / perStep)};
    }
    return {};
}

std::string Editor::State::title() const {
    if (scene == nullptr) {
        return "Kerf";
    }
    const EditorScene* const rests = scene.atRest();
    const std::size_t pieces =
        rests == nullptr ? told.pieces.rows.size() : rests->simulation().report().pieces;
    return "Kerf - " + scene.meanwhile().document().name + " - " +
           counted(pieces, "piece", "pieces");
}

}  // namespace kerf::app
