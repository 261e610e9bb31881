#pragma once

#include <cstdio>
#include <string>

namespace kerf::test {

/// As printf would print it, up to 255 characters.
template <class... Values>
std::string formatted(const char* format, Values... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

}  // namespace kerf::test
