#include "app/scene/editor_readings.h"

#include <algorithm>

namespace kerf::app {
namespace {

// Shares of the body's size: what counts as clear of the floor, and as back on it.
constexpr double kClear = 0.02;
constexpr double kTouching = 0.002;

}  // namespace

bool ImpactWatch::see(const std::vector<Bounds>& boxes, std::optional<double> floor, double size) {
    clear_.resize(boxes.size(), false);
    bool impact = false;
    for (std::size_t p = 0; p < boxes.size(); ++p) {
        const double height = floor && !boxes[p].empty() ? boxes[p].low.y() - *floor : 0;
        if (height > kClear * size) {
            clear_[p] = true;
        } else if (height < kTouching * size && clear_[p]) {
            clear_[p] = false;
            impact = impact || floor.has_value();
        }
    }
    return impact;
}

void EditorReadings::addStep(double time, const Simulation& simulation) {
    const StepReport& report = simulation.report();
    addState(time, simulation);
    stage(ui::Stage::deform).add(time, report.deformMs);
    stage(ui::Stage::collide).add(time, report.collideMs);
    stage(ui::Stage::cut).add(time, report.cutMs);
    history_.touchedTriangles.add(time, report.touchedTriangles);
    if (report.lostPieces > 0) {
        history_.lostPieces.add(time, history_.lostPieces.last() + report.lostPieces);
    }
    if (impacts_.see(simulation.pieceBounds(), simulation.params().floor,
                     simulation.bounds().diagonal())) {
        mark(time, "impact");
    }
}

void EditorReadings::addJump(double time, const Simulation& simulation) {
    addState(time, simulation);
}

void EditorReadings::addState(double time, const Simulation& simulation) {
    const StepReport& report = simulation.report();
    history_.volumePercent.add(time, 100 * report.volumeRatio);
    history_.kineticEnergy.add(time, report.kineticEnergy);
    history_.potentialEnergy.add(time, report.potentialEnergy);
    if (report.strainEnergy) {
        history_.strainEnergy.add(time, *report.strainEnergy);
    }
    history_.totalEnergy.add(
        time, report.kineticEnergy + report.potentialEnergy + report.strainEnergy.value_or(0.0));
    const std::vector<Piece> pieces = simulation.measuredPieces();
    const std::size_t shown = std::min<std::size_t>(pieces.size(), ui::kPlottedPieces);
    std::vector<ui::Series>& series = history_.piecePercent;
    series.resize(std::max(series.size(), shown));
    for (std::size_t p = 0; p < shown; ++p) {
        if (pieces[p].restVolume > 0) {
            series[p].add(time, 100 * pieces[p].volume / pieces[p].restVolume);
        }
    }
}

void EditorReadings::addPicture(double time, double elapsedSeconds, double renderMs) {
    history_.framesPerSecond.add(time, 1 / elapsedSeconds);
    stage(ui::Stage::frame).add(time, 1000 * elapsedSeconds);
    stage(ui::Stage::render).add(time, renderMs);
}

void EditorReadings::forgetAfter(double time) {
    for (ui::Series* series :
         {&history_.framesPerSecond, &history_.volumePercent, &history_.kineticEnergy,
          &history_.potentialEnergy, &history_.strainEnergy, &history_.totalEnergy,
          &history_.touchedTriangles, &history_.lostPieces}) {
        series->forgetAfter(time);
    }
    for (ui::Series& series : history_.stages) {
        series.forgetAfter(time);
    }
    for (ui::Series& series : history_.piecePercent) {
        series.forgetAfter(time);
    }
    std::erase_if(history_.marks, [time](const ui::PlotMark& mark) { return mark.x > time; });
    impacts_ = {};
}

std::optional<ui::RunFigures> EditorReadings::figures() const {
    const double frameMs = history_.stages[static_cast<std::size_t>(ui::Stage::frame)].mean();
    if (history_.volumePercent.empty() || frameMs <= 0) {
        return std::nullopt;
    }
    return ui::RunFigures{1000 / frameMs, history_.volumePercent.mean()};
}

}  // namespace kerf::app
