#pragma once

#include "render/scene/camera.h"
#include "ui/state/overlay.h"

namespace kerf::app {

/// A camera and the size of its frame: the mapping between pixels and the world.
struct ViewFrame {
    render::Camera camera;
    int width = 1;  ///< [px]
    int height = 1;

    bool operator==(const ViewFrame& other) const;
    double aspect() const { return double(width) / height; }
    Vec2 toNdc(const Vec2& pixel) const {
        return {2 * pixel.x() / width - 1, 1 - 2 * pixel.y() / height};
    }
    render::Ray rayThrough(const Vec2& pixel) const { return camera.ray(toNdc(pixel), aspect()); }
    /// The pixel of a point; none for points that are not in front of the eye.
    std::optional<ui::PlotPoint> toPixel(const Vec3& point) const;
    /// Adds the line between two points to `lines`, if both are in front of the eye.
    void addLine(const Vec3& from, const Vec3& to, std::vector<ui::Overlay::Line>& lines) const;
    /// The point where the ray through a pixel hits the plane through `point` that faces the eye.
    Vec3 onPlaneThrough(const Vec3& point, const Vec2& pixel) const;
};

}  // namespace kerf::app
