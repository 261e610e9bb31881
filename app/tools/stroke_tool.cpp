#include "app/scene/editor_stroke.h"
#include "app/tools/ruler.h"
#include "app/tools/tool_table.h"

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

}  // namespace

std::unique_ptr<Tool> makeStrokeTool() {
    return std::make_unique<StrokeTool>();
}

}  // namespace kerf::app
