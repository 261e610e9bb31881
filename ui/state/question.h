#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/scene/image.h"

namespace kerf::ui {

/// A choice that a user has to make before anything else; none where the text is empty.
struct Question {
    std::string title;
    std::string text;
    std::vector<std::string> choices;  ///< Enter takes the first, Esc the last
    std::shared_ptr<const render::Image> picture = nullptr;  ///< its subject; may be null
    /// It is at the lower edge of the view, which shows its subject and can be turned meanwhile.
    bool aside = false;
};

}  // namespace kerf::ui
