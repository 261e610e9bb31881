#pragma once

#include <nlohmann/json.hpp>

namespace kerf::app {

/// Nesting deeper than this is refused while parsing: deep documents overflow the stack later on.
inline constexpr int kMaxJsonDepth = 32;

/// A JSON document without duplicate keys, without numbers that are not finite and not nested
/// deeper than kMaxJsonDepth. Throws InputError with the line and column, or with the place.
nlohmann::json parseJson(std::string_view text);
/// parseJson() with the keys of each object in the order of the text.
nlohmann::ordered_json parseOrderedJson(std::string_view text);

}  // namespace kerf::app
