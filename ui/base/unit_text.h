#pragma once

namespace kerf::ui {

/// A text with superscripts in units: "m/s^2" with a raised 2.
std::string withRaisedDigits(std::string_view text);
/// A name of session files as a label: "cut_search" is "Cut search".
std::string asLabel(std::string_view name);

}  // namespace kerf::ui
