#include "app/editor/view/editor_panels.h"

#include <spdlog/spdlog.h>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/scene/editor_scene.h"
#include "app/scene/readout/scene_readout.h"
#include "app/session/paper_experiments.h"
#include "gpu/data_path.h"
#include "sim/run/simulation.h"
#include "ui/base/layout.h"
#include "ui/plots/plot_picture.h"
#include "ui/state/action_table.h"

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

constexpr int kPlotPictureWidth = 1200;  // [px]
constexpr int kPlotPictureHeight = 300;  // of each plot [px]
constexpr float kPanelRounding = 8;      // [px] at scale 1, at least that of the theme

using Cards = std::vector<ui::StartCard>;

std::shared_ptr<const Cards> readCards() {
    using ui::ToolKind;
    auto cards = std::make_shared<Cards>(Cards{
        {"citrus", "Citrus", "Drag all the way across it, then press Shift+Space."},
        {"banana", "Banana", "Cut off a few slices, then press Shift+Space."},
        {"octopus", "Octopus", "Cut off an arm, then press D and pull at another."},
        {"liver", "Liver", "Draw an incision, then press Y and drag across it to hold it open.",
         ToolKind::scalpel},
        {"jelly", "Jelly cube", "Press Shift+Space: it falls and wobbles. Then cut it."},
        {"tear", "Jelly to tear", "Pull its right half away from the slit.", ToolKind::grab},
        {"orange", "Orange to open", "Double the hand size, then drag the right half far away.",
         ToolKind::grab},
        {"incision", "Incision to tear",
         "Drag across the slit to hold it open. Too far, and it tears on.", ToolKind::retract},
        {"egg", "Hollow egg", "Cut it in two, then press Shift+Space: it falls open."},
        {"cloth", "Cloth", "Press Shift+Space: it drapes itself. Then cut it."},
        {"../practice/incision", "Practise: incision",
         "Draw along the line. Shift+Enter shows the score.", ToolKind::scalpel},
        {"../practice/excision", "Practise: excision",
         "Begin at the outer ring, go round, end there across your cut. Then Shift+Enter."},
        {"../practice/slice", "Practise: slice",
         "Cut down through the right line, then the left one. Then Shift+Enter."},
    });
    for (ui::StartCard& card : *cards) {
        try {
            card.picture = std::make_shared<render::Image>(
                readPicture(gpu::dataPath("assets/start/" + card.name + ".png")));
        } catch (const InputError& error) {
            spdlog::warn("{}", error.what());
        }
    }
    return cards;
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

EditorPanels::EditorPanels(const EditorOptions& options)
    : displayScale(options.scale),
      device(options.device),
      driver(options.driver),
      settings(options.settingsFile),
      interface(settings.now.theme, scale(options.width, options.height)),
      practice(options.tries) {
    showOne();
    ui::takeKeys(settings.now.keys);
}

float EditorPanels::scale(int width, int height) const {
    return std::min(displayScale * static_cast<float>(settings.now.uiScale),
                    ui::largestScale(width, height));
}

void EditorPanels::describe() {
    static const ui::History kNoHistory{};
    model = told;
    model.plots.history = told.plots.history != nullptr ? told.plots.history : &kNoHistory;
    model.settings = settings.now;
    model.settings.showControls &= !hidden;
    model.settings.showReadings &= !hidden;
    model.plots.view = plotView;
    model.help.open = helpOpen;
    model.help.samples = commandsOpen ? startCards() : nullptr;
    model.help.start = {startOpen ? startCards() : nullptr, !model.name.empty()};
    model.view.device = device;
    if (asked) {
        model.question = asked->question;
    }
}

void EditorPanels::answer(int choice, double number) {
    if (const std::optional<Asked> open = std::exchange(asked, std::nullopt)) {
        if (open->takeNumber) {
            open->takeNumber(number);
        }
        open->answer(choice);
    }
}

std::vector<ui::Action> EditorPanels::update(std::span<const ui::InputEvent> batch, int width,
                                             int height, double elapsedSeconds) {
    interface.restyle(settings.now.theme, scale(width, height));
    return interface.update(batch, model, width, height, elapsedSeconds);
}

/// Their rounded corners are left out.
std::vector<render::PixelRect> EditorPanels::covered(int width, int height) const {
    const int inset = static_cast<int>(std::ceil(kPanelRounding * scale(width, height)));
    std::vector<render::PixelRect> rects;
    for (const ui::Rect& rect : interface.covered()) {
        const int x = static_cast<int>(std::ceil(rect.x)) + inset;
        const int y = static_cast<int>(std::ceil(rect.y)) + inset;
        rects.push_back({x, y, static_cast<int>(rect.x + rect.width) - inset - x,
                         static_cast<int>(rect.y + rect.height) - inset - y});
    }
    return rects;
}

bool EditorPanels::shows(const std::string& section) const {
    return !hidden && settings.now.showControls &&
           std::ranges::find(settings.now.folded, section) == settings.now.folded.end();
}

void EditorPanels::unfold(const std::string& section) {
    std::erase(settings.now.folded, section);
}

void EditorPanels::toggle() {
    hidden = !hidden && settings.now.showsPanels();
    showOne();
}

void EditorPanels::take(ui::Settings wanted) {
    if (hidden) {
        hidden = !wanted.showsPanels();
        wanted.showControls |= settings.now.showControls;
        wanted.showReadings |= settings.now.showReadings;
    }
    settings.now = std::move(wanted);
    ui::takeKeys(settings.now.keys);
}

/// Without any panel there would be no menu.
void EditorPanels::showOne() {
    if (!settings.now.showsPanels()) {
        settings.now.showControls = settings.now.showReadings = true;
    }
}

render::Image EditorPanels::drawPlots(std::span<const ui::PlotSpec> plots) const {
    return ui::PlotPainter(settings.now.theme)
        .draw(plots, plotView, kPlotPictureWidth,
              kPlotPictureHeight * static_cast<int>(plots.size()));
}

std::shared_ptr<const Cards> startCards() {
    static const std::shared_ptr<const Cards> cards = readCards();
    return cards;
}

std::filesystem::path startSession(const std::string& name) {
    return gpu::dataPath("assets/start/" + name + ".kerf.json");
}

}  // namespace kerf::app
