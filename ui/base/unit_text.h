#pragma once

namespace kerf::ui {

/// A text with superscripts in units: "m/s^2" with a raised 2.
std::string withRaisedDigits(std::string_view text);
/// A name of session files as a label: "cut_search" is "Cut search".
std::string asLabel(std::string_view name);

/// The number that a text gives in `unit`: "5 mm" is 0.005 in m, a number alone is in `unit`. None
/// where it is no number, or its unit is unknown or of another kind.
std::optional<double> readNumber(std::string_view text, std::string_view unit);
/// What can be typed into a field of that unit: "Type a length, such as 5 mm".
std::string whatFits(std::string_view unit);

}  // namespace kerf::ui
