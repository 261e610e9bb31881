#pragma once

namespace kerf::ui {

/// The keys that the editor knows: its own list, so that neither the table of actions nor a test
/// depends on a window library. Letters, digits and function keys are one run each. questionMark
/// comes from the typed character, wherever the keyboard has it.
// clang-format off
enum class Key : std::uint8_t {
    none, space, enter, escape, tab, backspace, del, insert, left, right, up, down,
    pageUp, pageDown, home, end, period, slash, minus, equal, questionMark,
    a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
    digit0, digit1, digit2, digit3, digit4, digit5, digit6, digit7, digit8, digit9,
    f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
    count
};
// clang-format on

/// Modifier keys that are held.
struct Modifiers {
    bool shift = false;
    bool control = false;
    bool alt = false;
    bool operator==(const Modifiers&) const = default;
};

/// The buttons of the pointer that the editor knows.
enum class Button : std::uint8_t { left, right, middle };
inline constexpr int kButtons = 3;

/// The pointer is at (x, y), in pixels of the picture from its top left corner.
struct PointerMove {
    double x = 0;
    double y = 0;
    Modifiers modifiers;
};
/// A button of the pointer went down or up.
struct ButtonChange {
    Button button = Button::left;
    bool down = false;
    Modifiers modifiers;
};
/// Notches by which the wheel turned: y > 0 away from the user.
struct Wheel {
    double x = 0;
    double y = 0;
};
/// A key went down or up.
struct KeyChange {
    Key key = Key::none;
    bool down = false;
    Modifiers modifiers;
};
/// A typed character (Unicode code point).
struct Character {
    std::uint32_t code = 0;
};
/// Files dropped on the window.
struct FileDrop {
    std::vector<std::filesystem::path> files;
};
/// The window lost the focus: all held keys and buttons count as released.
struct FocusLost {};

using InputEvent =
    std::variant<PointerMove, ButtonChange, Wheel, KeyChange, Character, FileDrop, FocusLost>;

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
