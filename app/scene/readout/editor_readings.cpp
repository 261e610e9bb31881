#include "app/scene/readout/editor_readings.h"

#include "sim/mesh/invariants.h"
#include "sim/mesh/triangle_quality.h"

namespace kerf::app {

namespace {

/// Strain and change of area, each times the area at rest, and that area.
using Sums = Vec3;

Sums strainsOf(const SurfaceMesh& mesh, int triangle) {
    const Corners rest = restCornersOf(mesh, triangle);
    const Corners now = cornersOf(mesh, triangle);
    const double area = triangleArea(rest);
    if (!(area > 0)) {
        return Sums::Zero();
    }
    return area * Sums(largestStrain(rest, now), triangleArea(now) / area - 1, 1);
}

/// Around a vertex, over one kind of surface.
Sums strainsAround(const SurfaceMesh& mesh, int vertex, SurfaceKind kind) {
    Sums sums = Sums::Zero();
    mesh.forEachOutgoing(vertex, [&](int h) {
        if (mesh.kind(h / 3) == kind && mesh.present(h / 3)) {
            sums += strainsOf(mesh, h / 3);
        }
    });
    return sums;
}

// Shares of the body's size: what counts as clear of the floor, and as back on it.
constexpr double kClear = 0.02;
constexpr double kTouching = 0.002;
constexpr double kSettles = 1;  // within which the real-time factor takes up a new pace [s]

/// When a reading takes its value from the report.
enum class When {
    always,    ///< after a step and after a jump
    step,      ///< after a step
    addingUp,  ///< after a step where it is not 0, added to what was before
};

using ui::Reading;
using Report = const StepReport&;

/// A reading that comes from the report. Its series leaves out NaN.
struct FromReport {
    Reading reading;
    When when;
    double (*value)(Report);
};

double strainEnergyOf(Report r) {
    return r.strainEnergy.value_or(std::numeric_limits<double>::quiet_NaN());
}
double bladeForceOf(Report r) {
    return r.bladeLoad ? r.bladeLoad->force.norm() : std::numeric_limits<double>::quiet_NaN();
}
double energyOf(Report r) {
    return r.kineticEnergy + r.potentialEnergy + r.strainEnergy.value_or(0.0);
}

constexpr std::array kFromReport{
    FromReport{Reading::deformMs, When::step, [](Report r) { return r.times.deform; }},
    FromReport{Reading::collideMs, When::step, [](Report r) { return r.times.collide; }},
    FromReport{Reading::cutMs, When::step, [](Report r) { return r.times.cut; }},
    FromReport{Reading::volumePercent, When::always, [](Report r) { return 100 * r.volumeRatio; }},
    FromReport{Reading::kineticEnergy, When::always, [](Report r) { return r.kineticEnergy; }},
    FromReport{Reading::potentialEnergy, When::always, [](Report r) { return r.potentialEnergy; }},
    FromReport{Reading::strainEnergy, When::always, strainEnergyOf},
    FromReport{Reading::totalEnergy, When::always, energyOf},
    FromReport{Reading::touchedTriangles, When::step,
               [](Report r) { return 1.0 * r.touchedTriangles; }},
    FromReport{Reading::bladeForce, When::step, bladeForceOf},
    FromReport{Reading::bladeWork, When::addingUp, [](Report r) { return r.heldEdge.work; }},
    FromReport{Reading::fractureEnergy, When::addingUp, [](Report r) { return r.fractureEnergy; }},
    FromReport{Reading::lostPieces, When::addingUp, [](Report r) { return 1.0 * r.lostPieces; }},
};

/// The times of a picture of a running scene.
struct PictureTimes {
    FrameTime frame;
    double renderMs = 0;
    double stagesMs = 0;   ///< of its steps
    double simulated = 0;  ///< since the picture before [s]
};
using Times = const PictureTimes&;

/// A reading that comes from the pictures.
struct FromPicture {
    Reading reading;
    double (*value)(Times);
};
constexpr std::array kFromPicture{
    FromPicture{Reading::framesPerSecond, [](Times t) { return 1 / t.frame.all; }},
    FromPicture{Reading::frameMs, [](Times t) { return 1000 * t.frame.all; }},
    FromPicture{Reading::renderMs, [](Times t) { return t.renderMs; }},
    FromPicture{Reading::otherMs,
                [](Times t) { return std::max(0.0, 1000 * t.frame.steps - t.stagesMs); }},
    FromPicture{
        Reading::windowMs,
        [](Times t) { return std::max(0.0, 1000 * (t.frame.all - t.frame.steps) - t.renderMs); }},
    FromPicture{Reading::realTimeFactor, [](Times t) { return t.simulated / t.frame.all; }},
};

/// A reading of the plotted point.
struct FromPoint {
    Reading reading;
    double PointValues::*value;
    double unit;  ///< times the value
};
constexpr std::array kFromPoint{
    FromPoint{Reading::pointStrain, &PointValues::strain, 100},
    FromPoint{Reading::pointArea, &PointValues::area, 100},
    FromPoint{Reading::pointWay, &PointValues::way, 1},
    FromPoint{Reading::pointSpeed, &PointValues::speed, 1},
};

/// Whether each reading comes from somewhere, in the order of ui::Reading.
constexpr bool coversReadings() {
    std::size_t next = 0;
    const auto isNext = [&next](const auto& row) {
        return row.reading == Reading{static_cast<std::uint8_t>(next++)};
    };
    return std::ranges::all_of(kFromReport, isNext) && std::ranges::all_of(kFromPicture, isNext) &&
           std::ranges::all_of(kFromPoint, isNext) &&
           next == static_cast<std::size_t>(Reading::count);
}
static_assert(coversReadings(), "a Reading comes from nowhere, or not at its place");

}  // namespace

PointValues valuesAt(const SurfaceMesh& mesh, const SurfaceAnchor& anchor) {
    const Triangle& corners = mesh.triangle(anchor.triangle());
    bringAround(mesh, anchor.triangle());
    PointValues values;
    Vec3 velocity = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const double share = anchor.shares()[k];
        const Sums sums = strainsAround(mesh, corners[k], mesh.kind(anchor.triangle()));
        values.strain += share * sums[0] / sums[2];
        values.area += share * sums[1] / sums[2];
        velocity += share * mesh.velocity(corners[k]);
    }
    values.way = (anchor.position(mesh) - anchor.rest()).norm();
    values.speed = velocity.norm();
    return values;
}

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
    addReport(time, simulation, true);
    stagesMs_ += simulation.report().times.sum();
    if (impacts_.see(simulation.pieceBounds(), simulation.params().floor,
                     simulation.bounds().diagonal())) {
        mark(time, "impact");
    }
}

void EditorReadings::addJump(double time, const Simulation& simulation) {
    addReport(time, simulation, false);
    pictured_.reset();
}

void EditorReadings::addReport(double time, const Simulation& simulation, bool stepped) {
    for (const auto& [reading, when, valueIn] : kFromReport) {
        const double value = valueIn(simulation.report());
        if (when == When::always || (when == When::step && stepped)) {
            history_[reading].add(time, value);
        } else if (stepped && value != 0) {
            history_[reading].add(time, history_[reading].last() + value);
        }
    }
    addPieces(time, simulation.measuredPieces());
}

void EditorReadings::addPieces(double time, const std::vector<Piece>& pieces) {
    const std::size_t shown = std::min<std::size_t>(pieces.size(), ui::kPlottedPieces);
    std::vector<ui::Series>& series = history_.piecePercent;
    series.resize(std::max(series.size(), shown));
    for (std::size_t p = 0; p < shown; ++p) {
        if (pieces[p].restVolume > 0) {
            series[p].add(time, 100 * pieces[p].volume / pieces[p].restVolume);
        }
    }
}

void EditorReadings::addPicture(double time, const FrameTime& frame, double renderMs) {
    const double before = std::exchange(pictured_, time).value_or(time);
    const PictureTimes times{frame, renderMs, std::exchange(stagesMs_, 0), time - before};
    if (frame.all <= 0) {
        return;
    }
    for (const auto& [reading, valueIn] : kFromPicture) {
        history_[reading].add(time, valueIn(times));
    }
    if (times.simulated > 0) {
        const double factor = times.simulated / frame.all;
        const double former = realTimeFactor_.value_or(factor);
        realTimeFactor_ = former + (factor - former) * (1 - std::exp(-frame.all / kSettles));
    }
}

void EditorReadings::addPoint(double time, const PointValues& values) {
    for (const auto& [reading, value, unit] : kFromPoint) {
        history_[reading].add(time, unit * values.*value);
    }
}

void EditorReadings::forgetPoint() {
    for (const FromPoint& row : kFromPoint) {
        history_[row.reading] = {};
    }
}

void EditorReadings::forgetAfter(double time) {
    const auto forget = [time](ui::Series& series) { series.forgetAfter(time); };
    std::ranges::for_each(history_.readings, forget);
    std::ranges::for_each(history_.piecePercent, forget);
    std::erase_if(history_.marks, [time](const ui::PlotMark& mark) { return mark.x > time; });
    impacts_ = {};
    pictured_.reset();
}

std::optional<ui::RunFigures> EditorReadings::figures() const {
    const double frameMs = history_[Reading::frameMs].mean();
    if (history_[Reading::volumePercent].empty() || frameMs <= 0) {
        return std::nullopt;
    }
    return ui::RunFigures{1000 / frameMs, history_[Reading::volumePercent].mean()};
}

}  // namespace kerf::app
