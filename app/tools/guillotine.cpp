#include "app/tools/guillotine.h"

#include <Eigen/Geometry>

#include "app/scene/editor_stroke.h"
#include "app/tools/gizmo.h"
#include "app/tools/tool.h"
#include "app/tools/tool_marks.h"

namespace kerf::app {

namespace {

constexpr double kMargin = 0.15;    // of the diagonal, beyond the body on all sides
constexpr double kShortest = 1e-3;  // of what a handle is pulled to, of the length before

/// Poses a Guillotine by its handles and a gizmo, which goes in whole steps with Ctrl, and brings
/// it down.
class GuillotineTool : public Tool {
  public:
    void fitTo(const Bounds& bounds, ui::ToolSettings& settings) override {
        *this = {};
        settings.guillotine.lowered = 0;
        take(Guillotine(bounds), settings.guillotine);
    }

    std::string press(const ToolContext& c) override {
        before_ = guillotine_;
        handle_ = handleAt(c.view, c.pixel, guillotine_.handles());
        if (!handle_) {
            gizmo_.press(c.view, c.pixel, frame());
        }
        return "";
    }

    void move(const ToolContext& c) override {
        if (!holds()) {
            return;
        }
        raise(c);
        Guillotine moved = guillotine_;
        if (handle_) {
            moved.move(static_cast<Guillotine::Handle>(*handle_),
                       c.view.onPlaneThrough(moved.handles()[*handle_], c.pixel));
        } else {
            const GizmoChange change = gizmo_.moved(c.view, c.pixel, c.modifiers.control);
            moved = before_.moved(change.by, change.turn);
        }
        take(moved, c.settings.guillotine);
    }

    std::string release(const ToolContext& /*c*/) override {
        handle_.reset();
        gizmo_.release();
        return "";
    }

    void cancel(const ToolContext& c) override {
        if (holds()) {
            take(before_, c.settings.guillotine);
        }
        release(c);
        c.settings.guillotine.lowered = 0;
    }

    bool holds() const override { return handle_ || gizmo_.holds(); }

    /// A guillotine that is lowered cuts.
    void followSettings(const ui::ToolSettings& before, const ToolContext& c) override {
        ui::GuillotineSettings& now = c.settings.guillotine;
        if (now.length != before.guillotine.length || now.drop != before.guillotine.drop) {
            raise(c);
            guillotine_.setLength(now.length);
            guillotine_.setDrop(now.drop);
        } else if (now.lowered != before.guillotine.lowered) {
            lowerTo(std::exchange(now.lowered, before.guillotine.lowered), c);
        }
    }

    /// It falls from where it is.
    void trigger(const ToolContext& c) override {
        if (c.settings.guillotine.lowered >= 1) {
            c.settings.guillotine.lowered = 0;
        }
        lowerTo(1, c);
    }

    std::vector<Blade> wayAhead(const ToolContext& c) const override {
        const double lowered = c.settings.guillotine.lowered;
        return lowered < 1 ? std::vector{guillotine_.at(lowered), guillotine_.at(1)}
                           : std::vector<Blade>{};
    }

    void addTo(ui::Overlay& overlay, const ToolContext& c) const override {
        if (overlay.swept.empty()) {  // where it came down
            addSwept(overlay, {guillotine_.at(0), guillotine_.at(1)}, c.view);
        }
        const auto handles = guillotine_.handles();
        const std::optional<int> hot = handle_ ? handle_ : handleAt(c.view, c.pixel, handles);
        if (!handle_) {
            gizmo_.addTo(overlay, c.view, hot ? kNowhere : c.pixel, frame());
        }
        addHandles(overlay, c.view, handles, hot);
    }

    ui::Cursor cursor(const ui::Overlay& overlay) const override {
        return isOnHandle(overlay) ? ui::Cursor::hand : ui::Cursor::arrow;
    }

  private:
    void take(const Guillotine& guillotine, ui::GuillotineSettings& settings) {
        guillotine_ = guillotine;
        settings.length = guillotine_.length();
        settings.drop = guillotine_.drop();
    }

    /// Down it cuts; pulled up it is out of the body and above it again.
    void lowerTo(double lowered, const ToolContext& c) {
        double& now = c.settings.guillotine.lowered;
        if (lowered <= now || (now == 0 && c.stroke.drawing())) {  // a client's stroke
            raise(c);
            return;
        }
        if (!c.stroke.drawing()) {
            c.stroke.begin(guillotine_.at(now), {0.5, maxStrokeStep(c.bounds)});
        }
        now = lowered;
        c.stroke.moveTo(guillotine_.at(lowered));
        if (lowered >= 1) {
            c.stroke.end();
        }
    }

    static void raise(const ToolContext& c) {
        if (std::exchange(c.settings.guillotine.lowered, 0) > 0) {
            c.stroke.end();
        }
    }

    GizmoFrame frame() const { return {guillotine_.center(), guillotine_.axes()}; }

    Guillotine guillotine_;
    Guillotine before_;  ///< as it was when a handle or the gizmo was taken
    std::optional<int> handle_;
    Gizmo gizmo_;
};

}  // namespace

Guillotine::Guillotine(const Bounds& bounds) {
    const double margin = kMargin * bounds.diagonal();
    const Vec3 size = bounds.high - bounds.low;
    center_ = bounds.center();
    center_.y() = bounds.high.y() + margin;
    // Across the shorter of the two sides, so that a long body is parted.
    along_ = size.x() <= size.z() ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitZ());
    halfLength_ = 0.5 * std::min(size.x(), size.z()) + margin;
    drop_ = size.y() + 2 * margin;
}

Blade Guillotine::at(double lowered) const {
    const Vec3 now = center_ + lowered * drop_ * down_;
    return {now - halfLength_ * along_, now + halfLength_ * along_};
}

std::array<Vec3, Guillotine::kHandles> Guillotine::handles() const {
    return {center_, center_ - halfLength_ * along_, center_ + halfLength_ * along_,
            center_ + drop_ * down_};
}

void Guillotine::move(Handle handle, const Vec3& to) {
    const Vec3 arm = to - center_;
    switch (handle) {
        case middle:
            center_ = to;
            return;
        case endA:
            turnTo(-arm);
            return;
        case endB:
            turnTo(arm);
            return;
        case bottom: {
            const Vec3 square = arm - arm.dot(along_) * along_;
            if (square.norm() > kShortest * drop_) {
                down_ = square.normalized();
                drop_ = square.norm();
            }
            return;
        }
    }
}

Eigen::Matrix3d Guillotine::axes() const {
    Eigen::Matrix3d axes;
    axes << along_, -down_, along_.cross(-down_);
    return axes;
}

Guillotine Guillotine::moved(const Vec3& by, const Eigen::Matrix3d& turn) const {
    Guillotine moved = *this;
    moved.center_ += by;
    moved.along_ = (turn * along_).normalized();
    moved.down_ = (turn * down_).normalized();
    return moved;
}

void Guillotine::turnTo(const Vec3& along) {
    const Vec3 unit = along.normalized();
    const Vec3 square = down_ - down_.dot(unit) * unit;
    if (along.norm() > kShortest * halfLength_ && square.norm() > kShortest) {
        along_ = unit;
        halfLength_ = along.norm();
        down_ = square.normalized();
    }
}

std::unique_ptr<Tool> makeGuillotineTool() {
    return std::make_unique<GuillotineTool>();
}

}  // namespace kerf::app
