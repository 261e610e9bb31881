#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/scene/image.h"

namespace kerf::ui {

/// A scene that the start page offers.
struct StartCard {
    std::string name;  ///< of its file
    std::string title;
    std::string tip;                                         ///< what to try, one sentence
    std::shared_ptr<const render::Image> picture = nullptr;  ///< null if it can't be read
};

/// The page of scenes and recent files to start from.
struct StartState {
    std::shared_ptr<const std::vector<StartCard>> cards;  ///< null while the page is closed
    bool overScene = false;                               ///< a scene is open behind it
};

}  // namespace kerf::ui
