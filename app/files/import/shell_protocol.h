#pragma once

namespace kerf::app {

/// Messages between Kerf and `kerf-unite`. Simple on purpose: that program shares no other code
/// with Kerf, since it is linked with a library under the GPL.
struct ShellMessage {
    std::string failure = {};  ///< why there is no answer, a clause; all else is empty then
    std::vector<std::array<double, 3>> positions = {};
    std::vector<std::array<int, 3>> triangles = {};
    std::vector<int> pieces = {};  ///< by triangle, from 0; an answer has one piece
};

std::string encodeShells(const ShellMessage& message);
/// Trusts nothing: nullopt if lengths don't fit, an index is out of range, a piece is negative or
/// beyond the number of triangles, or a coordinate is not finite.
std::optional<ShellMessage> decodeShells(std::string_view bytes);

}  // namespace kerf::app
