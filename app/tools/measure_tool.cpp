#include "app/tools/measure_tool.h"

#include <spdlog/fmt/fmt.h>

#include <Eigen/Geometry>

#include "app/scene/readout/scene_readout.h"
#include "app/scene/section_pick.h"
#include "sim/base/text.h"
#include "sim/mesh/piece_figures.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

std::size_t pointsOf(ui::MeasureKind kind) {
    switch (kind) {
        case ui::MeasureKind::distance:
            return 2;
        case ui::MeasureKind::angle:
            return 3;
        case ui::MeasureKind::piece:
        case ui::MeasureKind::point:
            break;
    }
    return 1;
}

/// Lengths in the numbers of the model's own file.
class OwnUnit {
  public:
    explicit OwnUnit(const Placement& placement)
        : perMetre_(1 / (placement.scale * placement.metresPerUnit())),
          name_(placement.unit ? nameOf(*placement.unit) : "m") {}

    /// A figure of a length, an area or a volume: `dimension` 1, 2 or 3.
    ui::MeasureFigure figure(std::string quantity, double value, int dimension,
                             std::string text) const {
        const std::string power = dimension > 1 ? std::to_string(dimension) : "";
        ui::MeasureFigure figure{std::move(quantity), value, "m" + power, value, "",
                                 std::move(text)};
        if (perMetre_ != 1) {
            figure.ownValue = value * std::pow(perMetre_, dimension);
            figure.ownUnit = name_ + power;
            figure.text += fmt::format(" ({:.4g} {} in its file)", figure.ownValue, name_ + power);
        }
        return figure;
    }

  private:
    double perMetre_;
    std::string name_;
};

/// At the second of three points [degrees].
double angleAt(const std::vector<Vec3>& points) {
    const Vec3 a = points[0] - points[1];
    const Vec3 b = points[2] - points[1];
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

std::vector<ui::MeasureFigure> pieceFigures(const SurfaceAnchor& anchor, const SurfaceMesh& mesh,
                                            const OwnUnit& unit) {
    const PieceFigures piece = figuresOfPiece(mesh, PieceShells(mesh), anchor.triangle());
    std::vector<ui::MeasureFigure> figures{
        unit.figure("skin area", piece.skinArea, 2, areaText(piece.skinArea))};
    if (piece.cutArea > 0) {
        figures.push_back(unit.figure("cut area", piece.cutArea, 2, areaText(piece.cutArea)));
    }
    figures.push_back(unit.figure("volume", piece.volume, 3, volumeText(piece.volume)));
    return figures;
}

int nearestVertex(const SurfaceAnchor& anchor, const SurfaceMesh& mesh) {
    int corner = 0;
    anchor.shares().maxCoeff(&corner);
    return mesh.triangle(anchor.triangle())[corner];
}

std::vector<ui::MeasureFigure> pointFigures(const SurfaceAnchor& anchor, const SurfaceMesh& mesh,
                                            const OwnUnit& unit) {
    const PointValues values = valuesAt(mesh, anchor);
    const auto share = [](const char* name, double value) {
        return ui::MeasureFigure{name, value, "", value, "", fmt::format("{:.3g} %", 100 * value)};
    };
    const auto number = [](const char* name, int value) {
        return ui::MeasureFigure{name, double(value), "", double(value), "", std::to_string(value)};
    };
    return {
        share("area change", values.area),
        unit.figure("displacement", values.way, 1, lengthText(values.way)),
        {"speed", values.speed, "m/s", values.speed, "", fmt::format("{:.3g} m/s", values.speed)},
        share("strain", values.strain),
        number("triangle", anchor.triangle()),
        number("nearest vertex", nearestVertex(anchor, mesh))};
}

ui::PlotPoint between(const ui::PlotPoint& a, const ui::PlotPoint& b) {
    return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

}  // namespace

bool MeasureTool::Points::complete() const {
    return anchors.size() == pointsOf(kind);
}

bool MeasureTool::Points::follow(const SurfaceMesh& mesh) {
    const bool stays =
        std::ranges::all_of(anchors, [&mesh](SurfaceAnchor& a) { return a.follow(mesh); });
    if (stays) {
        std::ranges::transform(anchors, at.begin(),
                               [&mesh](const SurfaceAnchor& a) { return a.position(mesh); });
    }
    return stays;
}

std::string MeasureTool::press(const ToolContext& c) {
    const ui::MeasureKind kind = c.settings.measure;
    const auto point = pickVisible(*c.scene, c.view.rayThrough(c.pixel), c.section);
    if (!point) {
        return std::string(kBesideModel);
    }
    if (pending_.kind != kind) {
        pending_ = {kind, {}, {}};
    }
    pending_.anchors.emplace_back(c.scene->simulation().meshAsRead(), *point);
    pending_.at.push_back(point->position);
    if (pending_.complete()) {
        if (kind == ui::MeasureKind::point) {
            removePlotted();
            c.scene->readout().plot(pending_.anchors.front());
        }
        points_.push_back(std::exchange(pending_, {kind, {}, {}}));
        rows_.push_back({++lastId_, kind, {}, false});
        measure(rows_.size() - 1, *c.scene);
    }
    return "";
}

bool MeasureTool::escape(ui::ToolSettings& settings) {
    if (!dropPending()) {
        settings.tool = ui::kFirstTool;
    }
    return true;
}

bool MeasureTool::dropPending() {
    const bool had = !pending_.anchors.empty();
    pending_.anchors.clear();
    pending_.at.clear();
    return had;
}

bool MeasureTool::plotsPoint() const {
    return std::ranges::count(rows_, ui::MeasureKind::point, &ui::MeasureRow::kind) > 0;
}

/// One point is plotted at a time.
void MeasureTool::removePlotted() {
    const auto row = std::ranges::find(rows_, ui::MeasureKind::point, &ui::MeasureRow::kind);
    if (row != rows_.end()) {
        remove(row->id);
    }
}

void MeasureTool::remove(int id) {
    if (id == 0) {
        *this = {};
        return;
    }
    const auto row = std::ranges::find(rows_, id, &ui::MeasureRow::id);
    if (row != rows_.end()) {
        points_.erase(points_.begin() + (row - rows_.begin()));
        rows_.erase(row);
    }
}

std::string MeasureTool::follow(EditorScene& scene) {
    Simulation& simulation = scene.simulation();
    const bool moved = revision_ != simulation.bodyRevision();
    revision_ = simulation.bodyRevision();
    const bool sums = !scene.running() && areaRevision_ != revision_;
    if (!moved && !sums) {
        return "";
    }
    const SurfaceMesh& mesh = simulation.meshAsRead();
    if (!pending_.anchors.empty() && !pending_.follow(mesh)) {
        dropPending();
    }
    std::vector<std::string> ended;
    for (std::size_t i = 0; i < rows_.size();) {
        if (points_[i].follow(mesh)) {
            measure(i++, scene);
        } else {
            ended.push_back(std::to_string(rows_[i].id));
            remove(rows_[i].id);
        }
    }
    areaRevision_ = sums ? revision_ : areaRevision_;
    return ended.empty() ? ""
                         : counted(ended.size(), "measurement was", "measurements were") +
                               " removed, because their points were cut away.";
}

void MeasureTool::measure(std::size_t index, EditorScene& scene) {
    ui::MeasureRow& row = rows_[index];
    const Points& points = points_[index];
    const OwnUnit unit(scene.simulation().placement());
    switch (row.kind) {
        case ui::MeasureKind::distance: {
            const double length = (points.at[1] - points.at[0]).norm();
            row.figures = {unit.figure("distance", length, 1, lengthText(length))};
            return;
        }
        case ui::MeasureKind::angle: {
            const double angle = angleAt(points.at);
            row.figures = {{"angle", angle, "deg", angle, "", fmt::format("{:.4g}\u00b0", angle)}};
            return;
        }
        case ui::MeasureKind::piece:
            row.isOld = scene.running() && !row.figures.empty();
            if (!row.isOld) {
                row.figures = pieceFigures(points.anchors.front(), scene.simulation().mesh(), unit);
            }
            return;
        case ui::MeasureKind::point:
            row.figures =
                pointFigures(points.anchors.front(), scene.simulation().meshAsRead(), unit);
            return;
    }
}

// --- In the view -------------------------------------------------------------------------------

void MeasureTool::drawPoints(ui::Overlay& overlay, const ViewFrame& view,
                             const Points& points) const {
    for (std::size_t i = 0; i < points.at.size(); ++i) {
        if (const auto at = view.toPixel(points.at[i])) {
            overlay.dots.push_back(*at);
        }
        if (i > 0) {
            view.addLine(points.at[i - 1], points.at[i], overlay.guides);
        }
    }
}

void MeasureTool::addMeasures(ui::Overlay& overlay, const ViewFrame& view,
                              const Vec2& pixel) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        drawPoints(overlay, view, points_[i]);
        const std::vector<Vec3>& at = points_[i].at;
        const bool line = rows_[i].kind == ui::MeasureKind::distance;
        const auto a = view.toPixel(line ? at[0] : at[at.size() / 2]);
        const auto b = view.toPixel(line ? at[1] : at[at.size() / 2]);
        if (a && b && !rows_[i].figures.empty()) {
            overlay.labels.push_back({between(*a, *b), rows_[i].figures.back().text});
        }
    }
    drawPoints(overlay, view, pending_);
    if (!pending_.at.empty() && pixel.x() >= 0) {
        if (const auto last = view.toPixel(pending_.at.back())) {
            overlay.guides.push_back({*last, ui::PlotPoint{pixel.x(), pixel.y()}});
        }
    }
}

std::unique_ptr<Tool> makeMeasureTool() {
    return std::make_unique<MeasureTool>();
}

}  // namespace kerf::app
