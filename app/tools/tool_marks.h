#pragma once

#include "app/scene/readout/cut_preview.h"
#include "app/tools/tool.h"
#include "app/tools/view_frame.h"

namespace kerf::app {

class EditorScene;

/// The pick distance of handles [px].
inline constexpr double kHandleReach = 14;
/// Outside every frame [px].
inline const Vec2 kNowhere(-1e5, -1e5);

/// Whether searching the whole body would slow frames down, since it is large; for searches in each
/// frame, also if it moves.
bool isLarge(const EditorScene& scene);
bool isCostlyToFollow(const EditorScene& scene);

/// The number of the handle at a pixel; `handles` are points in the world [m].
std::optional<int> handleAt(const ViewFrame& view, const Vec2& pixel,
                            std::span<const Vec3> handles);
/// Adds handles, of which one may be hot.
void addHandles(ui::Overlay& overlay, const ViewFrame& view, std::span<const Vec3> handles,
                std::optional<int> hot);
/// Whether one of the handles shown, or a part of a gizmo, is hot.
bool isOnHandle(const ui::Overlay& overlay);

/// Adds a circle about a point of the surface; the radius is in metres.
void addRing(ui::Overlay& overlay, const ViewFrame& view, const SurfacePoint& point, double radius);

/// Adds the outline of a blade's path.
void addSwept(ui::Overlay& overlay, const std::vector<Blade>& way, const ViewFrame& view);

/// Adds the way from where the body is cut up to where the blade is led.
void addLag(ui::Overlay& overlay, const std::vector<Blade>& way, const ViewFrame& view);

/// Adds that of a coming cut, if any; between two steps also its intersection with the body.
void addPreview(ui::Overlay& overlay, const std::vector<Blade>& way, const ToolContext& c);

}  // namespace kerf::app
