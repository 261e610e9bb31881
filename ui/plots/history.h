#pragma once

#include "ui/plots/plot.h"
#include "ui/plots/plot_math.h"

namespace kerf::ui {

/// A value recorded over simulated time. The tables of app/scene/readout/editor_readings.cpp have
/// its source, in the same order.
enum class Reading : std::uint8_t {
    deformMs,
    collideMs,
    cutMs,
    volumePercent,    ///< of the uncut rest shape
    kineticEnergy,    ///< [J]
    potentialEnergy,  ///< [J]
    strainEnergy,     ///< [J]; nothing with plain PBD
    totalEnergy,      ///< the sum of those there are [J]
    touchedTriangles,
    bladeForce,      ///< on the blade [N]; nothing where it is not measured
    bladeWork,       ///< of the blade's edge, since the start [J]
    fractureEnergy,  ///< that new surface took since the start [J]
    lostPieces,      ///< reset since the start, if any
    framesPerSecond,
    frameMs,  ///< from picture to picture
    renderMs,
    otherMs,         ///< of the steps of a frame, beside their stages
    windowMs,        ///< of a frame, beside its steps and drawing the scene
    realTimeFactor,  ///< simulated seconds over seconds of the clock, from picture to picture
    // Of the plotted point, if any:
    pointStrain,  ///< the larger principal strain [%]
    pointArea,    ///< change of area [%]
    pointWay,     ///< from its place at rest [m]
    pointSpeed,   ///< [m/s]
    count
};

/// Number of pieces whose volumes the plots follow: the first ones.
inline constexpr int kPlottedPieces = 8;

/// The data of the plots of a run, over simulated time [s].
struct History {
    std::array<Series, static_cast<std::size_t>(Reading::count)> readings;
    std::vector<Series> piecePercent;  ///< of the rest volume of each, at most kPlottedPieces
    std::vector<PlotMark> marks;       ///< cuts, impacts, what was undone, by time

    Series& operator[](Reading reading) { return readings[static_cast<std::size_t>(reading)]; }
    const Series& operator[](Reading reading) const {
        return readings[static_cast<std::size_t>(reading)];
    }
};

/// The figures of a run that are compared with the paper's.
struct RunFigures {
    double fps = 0;     ///< mean [1/s]
    double volume = 0;  ///< mean [% of rest]
};

/// A curve of a plot, and how it is drawn.
struct CurveKind {
    const char* label = nullptr;
    Reading reading = Reading::count;
    Hue hue = Hue::blue;
    CurveStyle style = CurveStyle::solid;
};

/// A plot that can be chosen.
struct PlotKind {
    static constexpr std::size_t kMostCurves = 7;

    const char* id;                       ///< its name in Settings::plots and in files
    const char* title;                    ///< "Volume, % of rest"
    CurveKind curves[kMostCurves] = {};   ///< those with a label; none: a curve for each piece
    double minSpan = 1;                   ///< see PlotSpec
    int readoutDecimals = 1;              ///< see PlotSpec
    double RunFigures::*paper = nullptr;  ///< the figure of the paper that it is compared with
    std::optional<double> atRest = {};    ///< reference value if the paper has none
};

/// All plots in their order on the screen.
inline constexpr std::array kPlots{
    PlotKind{.id = "real_time",
             .title = "Real-time factor",
             .curves = {{"factor", Reading::realTimeFactor, Hue::vermillion}},
             .minSpan = 0.01,
             .readoutDecimals = 3},
    PlotKind{.id = "frames",
             .title = "Frames per second",
             .curves = {{"frames/s", Reading::framesPerSecond}},
             .minSpan = 10,
             .paper = &RunFigures::fps},
    PlotKind{.id = "times",
             .title = "Timings, ms",
             .curves = {{"frame", Reading::frameMs, Hue::gray, CurveStyle::dotted},
                        {"render", Reading::renderMs, Hue::purple, CurveStyle::dashed},
                        {"deform", Reading::deformMs},
                        {"cut", Reading::cutMs, Hue::vermillion},
                        {"collide", Reading::collideMs, Hue::green, CurveStyle::dashed},
                        {"other", Reading::otherMs, Hue::orange, CurveStyle::dotted},
                        {"window", Reading::windowMs, Hue::purple, CurveStyle::dotted}},
             .readoutDecimals = 2},
    PlotKind{.id = "volume",
             .title = "Volume, % of rest",
             .curves = {{"volume", Reading::volumePercent, Hue::green}},
             .readoutDecimals = 2,
             .paper = &RunFigures::volume,
             .atRest = 100},
    PlotKind{.id = "pieces", .title = "Volume by piece, % of rest", .readoutDecimals = 2},
    PlotKind{.id = "energy",
             .title = "Energy, J",
             .curves = {{"sum", Reading::totalEnergy, Hue::gray, CurveStyle::dotted},
                        {"potential", Reading::potentialEnergy, Hue::blue, CurveStyle::dashed},
                        {"strain", Reading::strainEnergy, Hue::green},
                        {"kinetic", Reading::kineticEnergy, Hue::orange}}},
    PlotKind{.id = "touched",
             .title = "Triangles divided by cuts",
             .curves = {{"triangles", Reading::touchedTriangles, Hue::vermillion}},
             .minSpan = 10,
             .readoutDecimals = 0},
    PlotKind{.id = "force",
             .title = "Force on the blade, N",
             .curves = {{"force", Reading::bladeForce, Hue::vermillion}},
             .minSpan = 0.01,
             .readoutDecimals = 3},
    PlotKind{
        .id = "work",
        .title = "Work of the blade, J",
        .curves = {{"work", Reading::bladeWork, Hue::blue},
                   {"new surface", Reading::fractureEnergy, Hue::vermillion, CurveStyle::dashed}},
        .minSpan = 0.001,
        .readoutDecimals = 4},
    PlotKind{.id = "fracture",
             .title = "Fracture energy, J",
             .curves = {{"new surface", Reading::fractureEnergy, Hue::vermillion}},
             .minSpan = 0.001,
             .readoutDecimals = 4},
};

/// The plots of a point of the surface, shown while one is plotted.
inline constexpr std::array kPointPlots{
    PlotKind{.id = "point_strain",
             .title = "Point: strain, %",
             .curves = {{"strain", Reading::pointStrain, Hue::purple},
                        {"area change", Reading::pointArea, Hue::orange, CurveStyle::dashed}},
             .readoutDecimals = 2},
    PlotKind{.id = "point_way",
             .title = "Point: displacement, m",
             .curves = {{"displacement", Reading::pointWay, Hue::green}},
             .minSpan = 1e-12,
             .readoutDecimals = 4},
    PlotKind{.id = "point_speed",
             .title = "Point: speed, m/s",
             .curves = {{"speed", Reading::pointSpeed, Hue::vermillion}},
             .minSpan = 1e-12,
             .readoutDecimals = 3},
};

}  // namespace kerf::ui
