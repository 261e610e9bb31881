#include "app/tools/stroke_tool.h"

#include "app/scene/editor_stroke.h"
#include "app/tools/tool.h"

namespace kerf::app {

namespace {

/// Leads the blade along the line of sight; with Shift along a line of the view.
class StrokeTool : public Tool {
  public:
    void fitTo(const Bounds& bounds, ui::ToolSettings& settings) override {
        settings.stroke.depth = 0.25 * bounds.diagonal();
        ruler_.reset();
    }

    /// Where an earlier stroke is still being cut, the poses of this one queue up behind it.
    std::string press(const ToolContext& c) override {
        const ui::StrokeSettings& settings = c.settings.stroke;
        const auto depth = settings.throughAll ? std::nullopt : std::optional(settings.depth);
        c.stroke.begin(StrokeSpace(c.view.camera, c.view.aspect(), c.bounds, depth),
                       c.view.toNdc(c.pixel));
        ruler_.emplace(c.pixel);
        return "";
    }

    void move(const ToolContext& c) override {
        if (!ruler_) {
            return;
        }
        const std::optional<Vec2> to = c.modifiers.shift ? ruler_->along(c.pixel) : c.pixel;
        if (to) {
            c.stroke.moveTo(c.view.toNdc(*to));
        }
    }

    std::string release(const ToolContext& c) override {
        if (ruler_) {
            ruler_.reset();
            c.stroke.end();
        }
        return "";
    }

    void cancel(const ToolContext& /*c*/) override { ruler_.reset(); }
    bool holds() const override { return ruler_.has_value(); }
    bool aims() const override { return false; }

  private:
    std::optional<Ruler> ruler_;  ///< while the blade is held
};

constexpr double kStep = std::numbers::pi / 12;

}  // namespace

std::unique_ptr<Tool> makeStrokeTool() {
    return std::make_unique<StrokeTool>();
}

std::optional<Vec2> Ruler::along(const Vec2& pixel) {
    const Vec2 way = pixel - start_;
    if (!direction_) {
        if (way.norm() < kTell) {
            return std::nullopt;
        }
        const double angle = kStep * std::round(std::atan2(way.y(), way.x()) / kStep);
        direction_ = Vec2(std::cos(angle), std::sin(angle));
    }
    return start_ + direction_->dot(way) * *direction_;
}

}  // namespace kerf::app
