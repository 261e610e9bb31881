#include "app/editor/view/experiment_board.h"

#include "app/scene/editor_scene.h"
#include "app/scene/readout/scene_readout.h"
#include "app/session/paper_experiments.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

/// The experiment that a scene shows; null for any other.
const PaperExperiment* experimentOf(const EditorScene* scene) {
    if (scene == nullptr) {
        return nullptr;
    }
    // Another session with the same model is no experiment, nor is one of that name that sleeps at
    // rest, as on the start page.
    const Document& document = scene->document();
    const PaperExperiment* experiment = findPaperExperiment(document.session.model.builtin);
    const bool same = experiment != nullptr && document.name == experiment->name;
    return same && document.session.params.sleeps == 0 ? experiment : nullptr;
}

}  // namespace

void ExperimentBoard::note(const EditorScene& scene) {
    const PaperExperiment* experiment = experimentOf(&scene);
    const auto figures = scene.readout().readings().figures();
    if (experiment != nullptr && figures) {
        runs_[experiment->name] = {*figures, scene.simulation().report().triangles};
    }
}

void ExperimentBoard::describe(const EditorScene* scene, ui::PanelModel& model) const {
    const PaperExperiment* open = experimentOf(scene);
    for (const PaperExperiment& paper : paperExperiments()) {
        ui::ExperimentCard& card = model.experiments.emplace_back();
        card.name = paper.name;
        card.label = paper.label;
        card.timeStep = paper.timeStep;
        card.iterations = paper.iterations;
        card.triangles = paper.triangles;
        card.paper = {paper.meanFps, paper.meanVolume};
        card.open = &paper == open;
        if (const auto run = runs_.find(card.name); run != runs_.end()) {
            card.ours = run->second.figures;
            card.ourTriangles = run->second.triangles;
        }
        if (card.open) {
            model.plots.paper = card.paper;
        }
    }
}

}  // namespace kerf::app
