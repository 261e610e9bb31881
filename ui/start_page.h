#pragma once

#include "gpu/framebuffer.h"
#include "ui/base/layout.h"
#include "ui/state/action.h"
#include "ui/state/window_state.h"

namespace kerf::ui {

/// The page to start from: cards with pictures of scenes, and recent files. It covers the window.
class StartPage {
  public:
    void draw(const StartState& state, std::span<const std::filesystem::path> recent,
              std::vector<Action>& actions);

  private:
    struct Sheet;
    void load(const StartState& state);
    void takeKeys();
    void drawCards(const Sheet& sheet, std::vector<Action>& actions);
    void drawRecent(const Sheet& sheet, std::span<const std::filesystem::path> recent,
                    std::vector<Action>& actions);
    bool chooses(const Rect& rect, const std::string& name);

    std::shared_ptr<const std::vector<StartCard>> shown_;
    std::vector<StartCard> cards_;        ///< of the scenes, and that of a file of one's own
    std::vector<gpu::Texture> pictures_;  ///< of `cards_`
    std::vector<Rect> items_;             ///< all that can be chosen, as last drawn [px]
    std::string opened_;                  ///< what is being opened, by its name here; "" for none
    std::size_t chosen_ = 0;              ///< of `items_`, by the pointer or the arrow keys
    bool moved_ = false;                  ///< by a key, in this update
    bool enters_ = false;                 ///< Enter was pressed in this update
};

}  // namespace kerf::ui
