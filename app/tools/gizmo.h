#pragma once

#include <Eigen/Core>

#include "app/tools/view_frame.h"
#include "render/scene/camera.h"
#include "sim/base/math.h"
#include "ui/state/overlay.h"

namespace kerf::app {

/// The subject of a gizmo: something with a place and axes, and perhaps a size.
struct GizmoFrame {
    Vec3 at = Vec3::Zero();                              ///< [m]
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: its own axes
    /// Half its size along its own axes; zero if it can't be resized [m].
    Vec3 half = Vec3::Zero();
    bool scales = false;  ///< as a whole
};

/// The change by a drag of a gizmo since the press.
struct GizmoChange {
    Vec3 by = Vec3::Zero();                              ///< [m]
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< about the place
    Vec3 grow = Vec3::Zero();                            ///< of the size along its own axes [m]
    double factor = 1;                                   ///< of the whole
};

/// Arrows that move, rings that turn, and handles that resize, drawn over the scene. One is held at
/// a time. It is independent of its subject.
class Gizmo {
  public:
    /// Grabs a part at a pixel of the frame. False if there is none.
    bool press(const ViewFrame& view, const Vec2& pixel, const GizmoFrame& frame);
    /// The change by the pointer at a pixel since the press; `snaps`: in whole steps.
    GizmoChange moved(const ViewFrame& view, const Vec2& pixel, bool snaps);
    void release() { held_.reset(); }
    bool holds() const { return held_.has_value(); }

    /// Adds the gizmo on `frame`, and the number of the drag.
    void addTo(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
               const GizmoFrame& frame) const;
    /// Whether a part is at a pixel.
    static bool isAt(const ViewFrame& view, const Vec2& pixel, const GizmoFrame& frame);

    /// Pixels of the tip of an arrow, for tests.
    static std::optional<Vec2> tipOf(const ViewFrame& view, const GizmoFrame& frame, int axis);
    /// Pixels of points of a ring, for tests.
    static std::vector<Vec2> ringOf(const ViewFrame& view, const GizmoFrame& frame, int axis);
    /// Pixels of the handle that sizes a side (1 or -1) along an axis, for tests.
    static std::optional<Vec2> faceOf(const ViewFrame& view, const GizmoFrame& frame, int axis,
                                      int side);
    /// Pixels of the handle that scales the whole, for tests.
    static std::optional<Vec2> cornerOf(const ViewFrame& view, const GizmoFrame& frame);

  private:
    enum class Kind { none, arrow, ring, face, corner };
    struct Part {
        Kind kind = Kind::none;
        int axis = 0;
        int side = 1;
        bool operator==(const Part&) const = default;
    };
    struct Held {
        Part part;
        GizmoFrame frame;   ///< at the press
        Vec2 from;          ///< [px]
        Vec2 last;          ///< [px]
        double turned = 0;  ///< so far [degrees]
        std::string label;
    };
    static Part partAt(const ViewFrame& view, const Vec2& pixel, const GizmoFrame& frame);
    GizmoChange shifted(const ViewFrame& view, const Vec2& pixel, bool snaps);
    GizmoChange turned(const ViewFrame& view, const Vec2& pixel, bool snaps);
    GizmoChange sized(const ViewFrame& view, const Vec2& pixel, bool snaps);
    GizmoChange scaled(const ViewFrame& view, const Vec2& pixel, bool snaps);
    std::optional<double> shiftOf(const ViewFrame& view, const Vec2& pixel) const;

    std::optional<Held> held_;
};

// What a drag in the picture means in the scene.

/// The position along an axis (unit, through `point`) nearest to a ray [m]. None if the ray is
/// nearly along the axis, so that a pixel would be a large distance.
std::optional<double> alongAxis(const render::Ray& ray, const Vec3& point, const Vec3& axis);

/// The angle about an axis (unit, through `center`) between the points where two rays hit the plane
/// across it [degrees], from -180 to 180. None if one doesn't hit it in front of the eye.
std::optional<double> turnAbout(const Vec3& center, const Vec3& axis, const render::Ray& from,
                                const render::Ray& to);

/// The distance of a pixel from a line between two [px].
double distanceToLine(const Vec2& pixel, const Vec2& from, const Vec2& to);

/// The multiple of `step` nearest to a value.
double snapped(double value, double step);

/// The least of 1, 2, 5, 10, 20 and so on, and of a tenth, hundredth and so on of them, that is no
/// less than `least`, which is above 0.
double roundStep(double least);

}  // namespace kerf::app
