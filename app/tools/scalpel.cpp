#include "app/tools/scalpel.h"

#include "app/scene/editor_scene.h"
#include "app/scene/editor_stroke.h"
#include "app/tools/tool.h"
#include "app/tools/tool_marks.h"

namespace kerf::app {

namespace {

/// Leads a Scalpel over the surface under the pointer.
class ScalpelTool : public Tool {
  public:
    void fitTo(const Bounds& bounds, ui::ToolSettings& settings) override {
        settings.scalpel.depth = 0.06 * bounds.diagonal();
        *this = {};
    }

    std::string press(const ToolContext& c) override {
        held_ = true;
        move(c);
        return "";
    }

    void move(const ToolContext& c) override {
        if (!held_) {
            return;
        }
        const auto point = c.scene->pick(c.view.rayThrough(c.pixel));
        if (!point) {
            scalpel_.reset();
            c.stroke.end();
            return;
        }
        if (!scalpel_) {
            scalpel_.emplace(c.settings.scalpel.depth);
        }
        for (const Blade& pose : scalpel_->moveTo(*point)) {
            if (c.stroke.drawing()) {
                c.stroke.moveTo(pose);
            } else {
                c.stroke.begin(pose, {0.5, maxStrokeStep(c.bounds)});
            }
        }
    }

    std::string release(const ToolContext& c) override {
        if (held_) {
            c.stroke.end();
        }
        *this = {};
        return "";
    }

    void cancel(const ToolContext& /*c*/) override { *this = {}; }
    bool holds() const override { return held_; }

    std::vector<Blade> wayAhead(const ToolContext& c) const override {
        if (const auto point = c.scene->pick(c.view.rayThrough(c.pixel))) {
            return {Scalpel(c.settings.scalpel.depth).at(*point)};
        }
        return {};
    }

    void addTo(ui::Overlay& overlay, const ToolContext& c) const override {
        if (const auto point = c.scene->pick(c.view.rayThrough(c.pixel))) {
            addRing(overlay, c.view, *point, c.settings.scalpel.depth);
        }
    }

    /// Its ring is drawn where there is something to cut.
    ui::Cursor cursor(const ui::Overlay& overlay) const override {
        return overlay.guides.empty() ? ui::Cursor::arrow : ui::Cursor::crosshair;
    }

  private:
    std::optional<Scalpel> scalpel_;  ///< while it is on the surface
    bool held_ = false;
};

}  // namespace

Blade Scalpel::at(const SurfacePoint& point) const {
    return {point.position + lift() * point.normal, point.position - depth_ * point.normal};
}

std::vector<Blade> Scalpel::moveTo(const SurfacePoint& point) {
    if (in_) {
        return {at(point)};
    }
    if (!first_) {
        first_ = point;
        return {};
    }
    const Vec3 way = point.position - first_->position;
    const Vec3 ahead = way - way.dot(first_->normal) * first_->normal;
    if (ahead.norm() < kTell * depth_) {
        return {};
    }
    in_ = true;
    const Blade upright = at(*first_);
    const Vec3 back = -(lift() + depth_) * ahead.normalized();
    // Level and behind, then steep, then upright: the edge swings down through the skin.
    const Blade level{upright.a, upright.a + back};
    const Blade steep{upright.a, upright.a + 0.7071 * (back + (upright.b - upright.a))};
    return {level, steep, upright, at(point)};
}

std::unique_ptr<Tool> makeScalpelTool() {
    return std::make_unique<ScalpelTool>();
}

}  // namespace kerf::app
