#pragma once

#include "app/tools/tool.h"

namespace kerf::app {

/// Holds cuts open (ui::ToolKind::retract): a press beside a cut hooks both lips, a drag pulls them
/// apart with the pointer, and they stay so. A drag of a hook moves its retractor.
class RetractTool : public Tool {
  public:
    static constexpr ui::ToolKind kTool = ui::ToolKind::retract;

    void fitTo(const Bounds& /*bounds*/, ui::ToolSettings& /*settings*/) override { *this = {}; }
    /// Hooks the lips near the pointer, or grabs a hook there.
    std::string press(const ToolContext& c) override;
    void move(const ToolContext& c) override;
    /// Leaves the hooks where they are.
    std::string release(const ToolContext& c) override;
    void putAway(const ToolContext& c) override { release(c); }
    /// Restores a retractor, or removes a new one.
    void cancel(const ToolContext& c) override;
    bool holds() const override { return drag_.has_value(); }
    /// On a hook, removes its retractor.
    bool takesRightClicks() const override { return true; }
    void rightClick(const ToolContext& c) override;
    /// Removes the retractor under the pointer, or else the last.
    void removeOne(const ToolContext& c);

    /// Adds the hooks, and the lips that a press would hook.
    void addTo(ui::Overlay& overlay, const ToolContext& c) const override;
    ui::Cursor cursor(const ui::Overlay& overlay) const override;

  private:
    /// A retractor that is being drawn apart.
    struct Opening {
        std::array<int, 2> hooks{};
        std::array<Vec3, 2> from;     ///< where they were [m]
        Vec3 across = Vec3::UnitX();  ///< unit, from the first to the second
        Vec3 at = Vec3::Zero();       ///< where the pointer grabbed it [m]
        bool isNew = true;
        double before = 0;  ///< their distance then [m]
        double by = 0;      ///< the increase of it [m]
    };
    void moveHooks(EditorScene& scene) const;
    std::string hookLips(const ToolContext& c);
    void takeAgain(int hook, const EditorScene& scene);
    static std::optional<int> hookAt(const ToolContext& c);
    static void addLips(ui::Overlay& overlay, const ToolContext& c);

    std::optional<Opening> drag_;
};

}  // namespace kerf::app
