#include "app/editor/view/editor_panels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editor/view/start_scenes.h"
#include "ui/base/layout.h"
#include "ui/plots/plot_picture.h"

namespace kerf::app {
namespace {

constexpr int kPlotPictureWidth = 1200;  // [px]
constexpr int kPlotPictureHeight = 300;  // of each plot [px]
constexpr float kPanelRounding = 8;      // [px] at scale 1, at least that of the theme

}  // namespace

EditorPanels::EditorPanels(const EditorOptions& options)
    : displayScale(options.scale),
      device(options.device),
      driver(options.driver),
      settings(options.settingsFile),
      interface(settings.now.theme, scale(options.width, options.height)),
      practice(options.tries) {
    showOne();
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
    model.help.start = {startOpen ? startCards() : nullptr, !model.name.empty()};
    model.view.device = device;
    if (asked) {
        model.question = asked->question;
    }
}

void EditorPanels::answer(int choice) {
    if (asked) {
        std::exchange(asked, std::nullopt)->answer(choice);
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

}  // namespace kerf::app
