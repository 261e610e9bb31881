#pragma once

#include <string>
#include <string_view>

namespace kerf {

/// A number with its noun: "1 piece", "3 pieces".
template <class Number>
std::string counted(Number count, std::string_view one, std::string_view many) {
    return std::to_string(count).append(" ").append(count == 1 ? one : many);
}

/// All words in one text with `separator` between them.
template <class Words>
std::string joined(const Words& words, std::string_view separator) {
    std::string text;
    for (const auto& word : words) {
        text.append(text.empty() ? "" : separator).append(word);
    }
    return text;
}

/// ASCII letters in lower case.
inline std::string lowerCase(std::string text) {
    for (char& c : text) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return text;
}

}  // namespace kerf
