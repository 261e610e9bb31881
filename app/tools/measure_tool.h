#pragma once

#include "app/scene/readout/surface_anchor.h"
#include "app/tools/tool.h"

namespace kerf::app {

/// Measurements by clicks on the body (ui::ToolKind::measure). Points stick to its material; a
/// measurement ends with the material of one of its points. They stay while other tools are used.
class MeasureTool : public Tool {
  public:
    static constexpr ui::ToolKind kTool = ui::ToolKind::measure;

    /// Adds a point of a measurement, which is complete once it has all of its points.
    std::string press(const ToolContext& c) override;
    /// Drops the points of an incomplete measurement.
    void putAway(const ToolContext& /*c*/) override { dropPending(); }
    /// Drops the points of an incomplete measurement; without any, selects the first tool.
    bool escape(ui::ToolSettings& settings) override;
    /// Whether there is anything to follow.
    bool any() const { return !rows_.empty() || !pending_.anchors.empty(); }
    /// Removes a measurement by its number, or all of them by 0.
    void remove(int id);
    /// Whether one of them is of the point that is plotted.
    bool plotsPoint() const;

    /// Follows the body between two steps: updates all points, and while paused the measures of
    /// pieces. Returns "" or a sentence about what ended.
    std::string follow(EditorScene& scene);

    const std::vector<ui::MeasureRow>& rows() const { return rows_; }
    /// Adds the measurements to the overlay, and a line from the last point to the pointer.
    void addMeasures(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel) const;

  private:
    /// Points of one measure.
    struct Points {
        ui::MeasureKind kind = ui::MeasureKind::distance;
        std::vector<SurfaceAnchor> anchors;
        std::vector<Vec3> at;  ///< where they were last [m]

        bool follow(const SurfaceMesh& mesh);
        bool complete() const;
    };
    bool dropPending();
    void removePlotted();
    void measure(std::size_t index, EditorScene& scene);
    void drawPoints(ui::Overlay& overlay, const ViewFrame& view, const Points& points) const;

    std::vector<Points> points_;  ///< of the measures in rows_
    std::vector<ui::MeasureRow> rows_;
    Points pending_;
    int lastId_ = 0;
    int revision_ = -1;  ///< of the body that the points were followed to
    int areaRevision_ = -1;
};

}  // namespace kerf::app
