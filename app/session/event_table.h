// One description of each session event: its type and its fields. Reader, writer, the list of types
// in errors and the test of docs/session-format.md are made from these.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <type_traits>
#include <variant>

#include "app/files/export.h"
#include "app/files/file_io.h"
#include "app/session/session.h"

namespace kerf::app {

/// The smallest and the largest value of a number, or of each coordinate of a vector.
struct Limits {
    double low;
    double high;
};
/// The limits from -limit to limit.
constexpr Limits within(double limit) {
    return {-limit, limit};
}
/// A text of so many lower-case hexadecimal digits.
struct HexDigits {
    std::size_t count;
};
/// Keys of some fields.
using Keys = std::initializer_list<const char*>;
/// The name of a file below the output folder that no replay writes of itself.
struct OutputName {};

inline constexpr Limits kCoordinates = within(kMaxSessionCoordinate);         // [m]
inline constexpr Limits kRadii{1e-9, kMaxSessionCoordinate};                  // [m]
inline constexpr Limits kHands{0, 99};                                        // their numbers
inline constexpr Limits kBoxNumbers{0, static_cast<double>(kMostBoxes) - 1};  // from 0
inline constexpr Limits kPictureSizes{1, kMaxPictureSize};                    // [pixels]
inline constexpr HexDigits kStateHashDigits{16};

// describe(fields, item) names what an item consists of to `fields`, which reads or writes it, by:
// - type(name): the `type` of an event; type(name, otherwise, flag): that of a true or false flag.
// - required(key, value, limits), optional(key, value, limits): a field. One that is left out keeps
//   its value, which is false for a bool and empty for a std::optional; these are not written then.
// - either(region, keys, otherKeys, problem): whether fields of a ball or of a box follow.
// - param(nameKey, name, valueKey, value): a parameter of the simulation and its value.
// - check(holds, key, problem): more that must hold, with the key that is to blame ("": the item).

void describe(auto& fields, Ball& ball) {
    fields.required("center", ball.center, kCoordinates);
    fields.required("radius", ball.radius, kRadii);
}

void describe(auto& fields, Bounds& box) {
    fields.required("low", box.low, kCoordinates);
    fields.required("high", box.high, kCoordinates);
    fields.check((box.low.array() <= box.high.array()).all(), "low",
                 "a box needs low to be no higher than high, in each direction.");
}

void describe(auto& fields, Region& region) {
    fields.either(region, {"center", "radius"}, {"low", "high"},
                  "expected either a ball (\"center\", \"radius\") or a box (\"low\", \"high\").");
    std::visit([&](auto& shape) { describe(fields, shape); }, region);
}

void describe(auto& fields, StaticBox& box) {
    fields.required("center", box.center, within(kFarthestBox));
    fields.required("size", box.size, within(kLargestBoxSize));
    fields.check(box.size.minCoeff() >= kLeastBoxSize, "size",
                 "each side of a box must be at least " + formatNumber(kLeastBoxSize) + " m long.");
    fields.optional("rotate", box.rotate, within(kLargestBoxTurn));
}

void describe(auto& fields, Placement& placement) {
    fields.optional("scale", placement.scale, Limits{1e-6, 1e6});
    fields.optional("rotate", placement.rotate, within(kLargestBoxTurn));
    fields.optional("translate", placement.translate, kCoordinates);
}

// The events, in the order of SessionAction.

void describe(auto& fields, MoveBlade& move) {
    fields.type("blade");
    fields.required("a", move.blade.a, kCoordinates);
    fields.required("b", move.blade.b, kCoordinates);
    fields.check(move.blade.a != move.blade.b, "a",
                 "a and b are the same point; a blade needs a length.");
}

void describe(auto& fields, LiftBlade&) {
    fields.type("lift");
}

void describe(auto& fields, SetParam& set) {
    fields.type("set");
    fields.param("name", set.name, "value", set.value);
    fields.optional("continues", set.continues);
}

void describe(auto& fields, Grab& grab) {
    fields.type("grab");
    fields.optional("hand", grab.hand, kHands);
    fields.required("at", grab.at, kCoordinates);
    fields.required("radius", grab.radius, kRadii);
}

void describe(auto& fields, Drag& drag) {
    fields.type("drag");
    fields.optional("hand", drag.hand, kHands);
    fields.required("to", drag.to, kCoordinates);
}

void describe(auto& fields, Release& release) {
    fields.type("release");
    fields.optional("hand", release.hand, kHands);
}

void describe(auto& fields, Pin& pin) {
    fields.type("pin", "unpin", pin.pinned);
    describe(fields, pin.region);
    fields.optional("continues", pin.continues);
}

void describe(auto& fields, AddBox& add) {
    fields.type("add_box");
    describe(fields, add.box);
}

void describe(auto& fields, ChangeBox& change) {
    fields.type("change_box");
    fields.required("box", change.index, kBoxNumbers);
    describe(fields, change.box);
    fields.optional("continues", change.continues);
}

void describe(auto& fields, RemoveBox& remove) {
    fields.type("remove_box");
    fields.required("box", remove.index, kBoxNumbers);
}

void describe(auto& fields, Restart&) {
    fields.type("restart");
}

void describe(auto& fields, Undo&) {
    fields.type("undo");
}

void describe(auto& fields, Redo&) {
    fields.type("redo");
}

void describe(auto& fields, ScreenshotEvent& event) {
    fields.type("screenshot");
    fields.required("file", event.file, OutputName{});
    fields.check(std::filesystem::path(event.file).extension() == ".png", "file",
                 "'" + event.file + "' must end in .png.");
    fields.optional("width", event.width, kPictureSizes);
    fields.optional("height", event.height, kPictureSizes);
}

void describe(auto& fields, ExportEvent& event) {
    fields.type("export");
    fields.required("file", event.file, OutputName{});
    fields.check(meshFormatOf(event.file).has_value(), "file",
                 "'" + event.file + "' must end in .ply, .obj, .stl, .glb or .gltf.");
    fields.optional("per_piece", event.filePerPiece);
}

void describe(auto& fields, CheckEvent& event) {
    fields.type("check");
    fields.optional("hash", event.hash, kStateHashDigits);
    fields.optional("pieces", event.pieces, Limits{1, kMaxSteps});
    fields.check(event.hash || event.pieces, "", "a check needs \"hash\" or \"pieces\".");
}

/// Calls `visit` with an event of each kind, as it is before any field is known, in the order of
/// the variant.
template <class... Events, class Visit>
void forEachKind(std::type_identity<std::variant<Events...>>, Visit visit) {
    (visit(Events{}), ...);
}

}  // namespace kerf::app
