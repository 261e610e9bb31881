#include "app/scene/editor_scene.h"
#include "app/scene/readout/cut_preview.h"
#include "app/session/event_table.h"
#include "app/tools/box_placement.h"
#include "app/tools/tool.h"
#include "app/tools/tool_marks.h"

namespace kerf::app {
namespace {

constexpr double kBrushSpacing = 8;  // between two dabs of a fast drag [px]
constexpr double kLeastBox = 4;      // a smaller one was a click [px]

void addBox(const ViewFrame& view, const Bounds& box, ui::Overlay& overlay) {
    for (int corner = 0; corner < 8; ++corner) {
        for (const int bit : {1, 2, 4}) {
            if ((corner & bit) == 0) {
                view.addLine(box.corner(corner), box.corner(corner | bit), overlay.guides);
            }
        }
    }
}

/// Fixes, moves or pushes parts of the body by a brush, with Shift by a box, and with Ctrl frees
/// them again.
class PinTool : public Tool {
  public:
    void fitTo(const Bounds& bounds, ui::ToolSettings& settings) override {
        settings.pin.radius = 0.08 * bounds.diagonal();
        *this = {};
    }

    std::string press(const ToolContext& c) override {
        const bool pins = !c.modifiers.control;
        if (c.modifiers.shift) {
            box_ = Box{pins, c.pixel, c.pixel};
        } else {
            brush_ = Brush{c.settings.pin.radius, pins, false, c.pixel};
            paint(c.pixel, c);
        }
        return "";
    }

    void move(const ToolContext& c) override {
        if (brush_) {
            paintUpTo(c);
        } else if (box_) {
            box_->to = c.pixel;
        }
    }

    /// Pins or frees what is in the box.
    std::string release(const ToolContext& c) override {
        std::string problem;
        if (box_ && (box_->to - box_->from).norm() >= kLeastBox) {
            problem = change(between(*box_, c), box_->pins, false, c);
        }
        *this = {};
        return problem;
    }

    void cancel(const ToolContext& /*c*/) override { *this = {}; }
    bool holds() const override { return brush_ || box_; }

    void addTo(ui::Overlay& overlay, const ToolContext& c) const override {
        if (box_) {
            addBox(c.view, between(*box_, c), overlay);
        } else if (const auto point = c.scene->pick(c.view.rayThrough(c.pixel))) {
            addRing(overlay, c.view, *point, c.settings.pin.radius);
        }
    }

    /// Its ring is drawn where there is something to pin; Shift draws the box anywhere.
    ui::Cursor cursor(const ui::Overlay& overlay) const override {
        return overlay.guides.empty() ? ui::Cursor::arrow : ui::Cursor::crosshair;
    }

  private:
    struct Brush {
        double radius = 0;  ///< [m]
        bool pins = true;   ///< false: frees
        bool begun = false;
        Vec2 last = Vec2::Zero();  ///< [px]
    };
    struct Box {
        bool pins = true;
        Vec2 from = Vec2::Zero();  ///< [px]
        Vec2 to = Vec2::Zero();
    };

    static std::string change(const Region& region, bool pins, bool continues,
                              const ToolContext& c) {
        const ui::PinSettings& chosen = c.settings.pin;
        if (chosen.kind == ui::PinKind::push) {
            const Vec3 force = pins ? chosen.newtons : Vec3(Vec3::Zero());
            return c.scene->execute(ApplyForce{region, force, continues});
        }
        Pin pin{region, pins, continues};
        if (pins && chosen.kind == ui::PinKind::move) {
            pin.velocity = chosen.velocity;
            pin.seconds = chosen.seconds > 0
                              ? std::optional(std::max(chosen.seconds, kDurations.low))
                              : std::nullopt;
        }
        return c.scene->execute(pin);
    }

    static Bounds between(const Box& box, const ToolContext& c) {
        return boxBetween(c.view, box.from, box.to, c.bounds);
    }

    void paintUpTo(const ToolContext& c) {
        const Vec2 from = brush_->last;
        const Vec2 way = c.pixel - from;
        const int dabs = std::max(1, static_cast<int>(std::ceil(way.norm() / kBrushSpacing)));
        for (int k = 1; k <= dabs; ++k) {
            paint(from + way * k / dabs, c);
        }
        brush_->last = c.pixel;
    }

    /// Where all is pinned already nothing changes; that is no problem.
    void paint(const Vec2& pixel, const ToolContext& c) {
        const auto point = c.scene->pick(c.view.rayThrough(pixel));
        const auto dab = [&] { return Ball{point->position, brush_->radius}; };
        if (point && change(dab(), brush_->pins, brush_->begun, c).empty()) {
            brush_->begun = true;
        }
    }

    std::optional<Brush> brush_;
    std::optional<Box> box_;
};

}  // namespace

std::unique_ptr<Tool> makePinTool() {
    return std::make_unique<PinTool>();
}

}  // namespace kerf::app
