#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/state/start_state.h"

namespace kerf::app {

/// A scene of the start page: a session and a picture in assets/start.
struct StartScene {
    const char* name;   ///< of its files, without endings
    const char* title;  ///< for people
    const char* tip;    ///< what to try in it, one sentence

    std::filesystem::path session() const;
    std::filesystem::path picture() const;
};

/// All scenes, in the order of the page.
std::span<const StartScene> startScenes();
/// The scene of a name; null for an unknown one.
const StartScene* findStartScene(std::string_view name);

/// The cards of the page with their pictures, which are read once.
std::shared_ptr<const std::vector<ui::StartCard>> startCards();

}  // namespace kerf::app
