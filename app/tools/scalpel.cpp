#include "app/tools/scalpel.h"

#include "app/scene/editor_scene.h"
#include "app/scene/editor_stroke.h"
#include "app/tools/gizmo.h"
#include "app/tools/tool.h"
#include "app/tools/tool_marks.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr double kNotches = 1000;  // of the wheel, through the longest depth

SurfacePoint onTheWay(const SurfacePoint& from, const SurfacePoint& to, double share) {
    return {from.triangle, from.position + share * (to.position - from.position),
            (from.normal + share * (to.normal - from.normal)).stableNormalized()};
}

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

    /// While it cuts, the wheel changes its depth.
    bool turnWheel(double notches, const ToolContext& c) override {
        if (held_) {
            const double step = roundStep(c.settings.longest / kNotches);
            double& depth = c.settings.scalpel.depth;
            depth =
                std::clamp(step * (std::round(depth / step) + notches), step, c.settings.longest);
            if (scalpel_) {
                scalpel_->setDepth(depth);
            }
        }
        return held_;
    }
    std::string figure(const ui::ToolSettings& settings) const override {
        return held_ ? millimetreText(settings.scalpel.depth) : "";
    }

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

Blade Scalpel::at(const SurfacePoint& point, double depth) const {
    return {point.position + lift() * point.normal, point.position - depth * point.normal};
}

std::vector<Blade> Scalpel::moveTo(const SurfacePoint& point) {
    if (!last_) {
        last_ = point;
        return {};
    }
    const double step = (point.position - last_->position).norm();
    if (way_ == 0 && step < kTell * depth_) {
        return {};
    }
    std::vector<Blade> poses;
    if (way_ == 0) {
        poses.push_back(at(*last_, -kAbove * depth_));
    }
    const double end = way_ + step;
    if (way_ < wayIn() && end > wayIn()) {
        poses.push_back(at(onTheWay(*last_, point, (wayIn() - way_) / step)));
    }
    poses.push_back(at(point, std::min(depth_, end / kWayIn)));
    last_ = point;
    way_ = end;
    return poses;
}

std::unique_ptr<Tool> makeScalpelTool() {
    return std::make_unique<ScalpelTool>();
}

}  // namespace kerf::app
