#pragma once

namespace kerf::ui {

/// The shape of the pointer: what a click or a drag would do.
enum class Cursor : std::uint8_t {
    arrow,
    text,       ///< types
    hand,       ///< takes hold of what is below
    crosshair,  ///< cuts or pins here
    resizeX,    ///< moves an edge to the left or the right
    resizeY,    ///< up or down
};
inline constexpr int kCursors = 6;

}  // namespace kerf::ui
