#pragma once

#include <string>
#include <vector>

#include "app/scene/editor_scene.h"
#include "app/tools/surface_anchor.h"
#include "app/tools/view_frame.h"
#include "ui/measures.h"

namespace kerf::app {

/// What a person measures by clicks on the body. Points stick to its material; a measure ends with
/// the material of one of its points.
class MeasureList {
  public:
    /// Takes a point of a measure of that kind, which is there once it has all of its points.
    void click(ui::MeasureKind kind, const SurfacePoint& point, EditorScene& scene);
    /// Forgets the points of a measure that is not there yet. False where there are none.
    bool dropPending();
    /// Whether there is anything to follow.
    bool any() const { return !rows_.empty() || !pending_.anchors.empty(); }
    void remove(int id);
    void clear() { *this = {}; }

    /// Goes on with the body between two of its steps: where all points are, and while time stands
    /// what the pieces measure. Returns "" or a sentence about what ended.
    std::string follow(EditorScene& scene);

    const std::vector<ui::MeasureRow>& rows() const { return rows_; }
    /// Adds the measures to what the view shows, and from the last point a line to the pointer.
    void addTo(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel) const;

  private:
    /// Points of one measure.
    struct Points {
        ui::MeasureKind kind = ui::MeasureKind::distance;
        std::vector<SurfaceAnchor> anchors;
        std::vector<Vec3> at;  ///< where they were last [m]

        bool follow(const SurfaceMesh& mesh);
        bool complete() const;
    };
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
