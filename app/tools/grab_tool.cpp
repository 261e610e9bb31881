#include "app/scene/editor_scene.h"
#include "app/scene/held_hands.h"
#include "app/scene/readout/cut_preview.h"
#include "app/tools/tool.h"
#include "app/tools/tool_marks.h"

namespace kerf::app {
namespace {

/// Pulls at the body.
class GrabTool : public Tool {
  public:
    void fitTo(const Bounds& bounds, ui::ToolSettings& settings) override {
        settings.grab.radius = 0.12 * bounds.diagonal();
        held_.reset();
    }

    std::string press(const ToolContext& c) override {
        const auto point = c.scene->pick(c.view.rayThrough(c.pixel));
        if (!point) {
            return std::string(kBesideModel);
        }
        std::string problem = c.scene->hands().grab(point->position, c.settings.grab.radius);
        if (problem.empty()) {
            held_ = to_ = point->position;
        }
        return problem;
    }

    void move(const ToolContext& c) override {
        if (held_) {
            to_ = c.view.onPlaneThrough(*held_, c.pixel);
            c.scene->hands().dragTo(to_);
        }
    }

    std::string release(const ToolContext& c) override {
        if (held_) {
            c.scene->hands().letGoThere();
            held_.reset();
        }
        return "";
    }

    void cancel(const ToolContext& c) override {
        if (std::exchange(held_, std::nullopt)) {
            c.scene->hands().letGo();
        }
    }
    bool holds() const override { return held_.has_value(); }

    void addTo(ui::Overlay& overlay, const ToolContext& c) const override {
        const double wanted = c.settings.grab.radius;
        if (held_) {
            addHandles(overlay, c.view, {&to_, 1}, 0);
        } else if (const auto point = c.scene->pick(c.view.rayThrough(c.pixel))) {
            const bool fits = !isCostlyToFollow(*c.scene);
            addRing(overlay, c.view, *point,
                    fits ? c.scene->hands().reachAt(point->position, wanted) : wanted);
        }
    }

    /// Its ring is drawn where there is something to hold.
    ui::Cursor cursor(const ui::Overlay& overlay) const override {
        return overlay.guides.empty() ? ui::Cursor::arrow : ui::Cursor::hand;
    }

  private:
    std::optional<Vec3> held_;  ///< where it took hold [m]
    Vec3 to_ = Vec3::Zero();    ///< where it has pulled that [m]
};

}  // namespace

std::unique_ptr<Tool> makeGrabTool() {
    return std::make_unique<GrabTool>();
}

}  // namespace kerf::app
