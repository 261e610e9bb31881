#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ui/base/layout.h"
#include "ui/base/picture.h"
#include "ui/state/action.h"
#include "ui/state/start_state.h"

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
    void drawCards(const StartState& state, const Sheet& sheet, std::vector<Action>& actions);
    void drawCard(const Sheet& sheet, const Rect& rect, const StartCard& card,
                  const Picture& picture);
    void drawRecent(const Sheet& sheet, std::span<const std::filesystem::path> recent,
                    std::vector<Action>& actions);
    bool chooses(const Rect& rect, const std::string& name);

    std::shared_ptr<const std::vector<StartCard>> cards_;
    std::vector<Picture> pictures_;  ///< of `cards_`, and an empty one behind them
    std::vector<Rect> items_;        ///< all that can be chosen, as last drawn [px]
    std::size_t chosen_ = 0;         ///< of `items_`, by the pointer or the arrow keys
    bool moved_ = false;             ///< by a key, in this update
    bool enters_ = false;            ///< Enter was pressed in this update
};

}  // namespace kerf::ui
