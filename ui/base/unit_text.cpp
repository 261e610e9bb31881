#include "ui/base/unit_text.h"

#include <cctype>

namespace kerf::ui {

std::string withRaisedDigits(std::string_view text) {
    std::string raised;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view two = text.substr(i, 2);
        if (two == "^2" || two == "^3") {
            raised += text[++i] == '2' ? "\u00b2" : "\u00b3";
        } else {
            raised += text[i];
        }
    }
    return raised;
}

std::string asLabel(std::string_view name) {
    std::string label(name);
    std::ranges::replace(label, '_', ' ');
    label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
    return label;
}

}  // namespace kerf::ui
