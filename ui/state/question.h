#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/scene/image.h"

namespace kerf::ui {

/// A choice that a person has to make before anything else; none where the text is empty.
struct Question {
    std::string title;
    std::string text;
    std::vector<std::string> choices;  ///< Enter takes the first, Esc the last
    std::shared_ptr<const render::Image> picture = nullptr;  ///< what it is about; may be null
    /// It stands at the lower edge of the view, which can be turned meanwhile: what it is about is
    /// seen there.
    bool aside = false;
};

}  // namespace kerf::ui
