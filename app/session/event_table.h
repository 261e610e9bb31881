// One description of each session event: its type and its fields. Reader, writer, the schema for
// text editors, the list of types in errors and the test of docs/session-format.md are made from
// these. session_table.h has the rest of a session.
#pragma once

#include <initializer_list>
#include <type_traits>

#include "app/files/export/mesh_formats.h"
#include "app/session/session.h"

namespace kerf::app {

/// A key, or a type of events, and a sentence for people who write sessions by hand.
struct Word {
    const char* name;
    const char* meaning;
};
/// The name and the version of a format of files.
struct FileFormat {
    const char* name;
    int version;
};
/// Names of some keys.
using Keys = std::initializer_list<const char*>;

/// The smallest and the largest value of a number, or of each coordinate of a vector.
struct Limits {
    double low;
    double high;
};
/// The limits from -limit to limit.
constexpr Limits within(double limit) {
    return {-limit, limit};
}
/// A text of `count` lower-case hexadecimal digits.
struct HexDigits {
    std::size_t count;
};
/// The name of a file below the output folder that is not reserved for replays, with one of these
/// endings (".png"), case-insensitive.
struct OutputName {
    std::vector<std::string_view> endings;
};
/// A text of at most `most` bytes.
struct ShortText {
    std::size_t most;
};
/// One of these words, by the number of the enumerator; of a list of texts, each is one of them.
struct Words {
    std::span<const std::string_view> words;
};

/// The key of an event that names its type.
inline constexpr const char* kTypeKey = "type";

inline constexpr Limits kCoordinates = within(kMaxSessionCoordinate);  // [m]
/// A position in the scene, which depends on the origin.
struct Positions : Limits {};
inline constexpr Positions kPositions{kCoordinates};
inline constexpr Limits kScales{1e-6, 1e6};
inline constexpr Limits kRadii{1e-9, kMaxSessionCoordinate};                  // [m]
inline constexpr Limits kHands{0, 99};                                        // their numbers
inline constexpr Limits kBoxNumbers{0, static_cast<double>(kMostBoxes) - 1};  // from 0
inline constexpr Limits kPieceNumbers{0, 1e6};                                // from 0
inline constexpr Limits kModelNumbers{0, kMostModels - 1};                    // from 0
inline constexpr Limits kObjectNumbers{1, 1e6};
inline constexpr Limits kBoxSizes{kLeastBoxSize, kLargestBoxSize};  // [m]
inline constexpr Limits kSpeeds = within(1000);                     // [m/s]
inline constexpr Limits kDurations{1e-6, 1e6};                      // [s]
inline constexpr Limits kForces = within(1e9);                      // [N]
inline constexpr Limits kTurns = within(kLargestBoxTurn);           // [degrees]
inline constexpr Limits kPictureSizes{1, kMaxPictureSize};          // [pixels]
inline constexpr Limits kFieldsOfView{1, 150};                      // [degrees]
inline constexpr double kLeastSineOfUp = 1e-6;  // between the line of sight and the camera's up
inline constexpr HexDigits kStateHashDigits{16};
inline constexpr ShortText kLabels{60};

inline constexpr Word kRotate{"rotate",
                              "Turns about the world's x, then y, then z axis, in degrees."};
inline constexpr Word kHand{"hand", "The number of the hand."};

// describe(fields, item) names what an item consists of to `fields`, which reads or writes it, by:
// - type(word): the `type` of an event; type(word, otherwise, flag): that of a true or false flag.
// - required(word, value, rule), optional(word, value, rule): a field, and what it must be like.
//   One that is left out keeps its value, which is false for a bool and empty for a std::optional;
//   these are not written then.
// - exactlyOneOf(keys, problem), atLeastOneOf(keys, problem): which optional fields must be there.
// - oneOf(region, problem): the fields of a ball or those of a box.
// - param(nameWord, name, valueWord, value): a parameter of the simulation and its value.
// - list(word, items, most): at most so many items; none where it is left out.
// - check(holds, key, problem): more that must hold, with the key that is to blame ("": the item).
//   A schema can't tell these.

/// A default for `fields` without special rules; others hide it.
struct NoFields {
    void type(const Word&) {}
    void type(const Word&, const Word&, bool) {}
    void required(const Word&, const auto&, const auto&...) {}
    void optional(const Word&, const auto&, const auto&...) {}
    void exactlyOneOf(Keys, std::string_view) {}
    void atLeastOneOf(Keys, std::string_view) {}
    void oneOf(const Region&, std::string_view) {}
    void param(const Word&, const std::string&, const Word&, const ParamValue&) {}
    void check(bool, const char*, std::string_view) {}
    void list(const Word&, const auto&, std::size_t) {}
};

void describe(auto& fields, Ball& ball) {
    fields.required({"center", "The middle of the ball [m]."}, ball.center, kPositions);
    fields.required({"radius", "The radius of the ball [m]."}, ball.radius, kRadii);
}

void describe(auto& fields, Bounds& box) {
    fields.required({"low", "The lowest corner of the box [m]."}, box.low, kPositions);
    fields.required({"high", "The highest corner of the box [m]."}, box.high, kPositions);
    fields.check((box.low.array() <= box.high.array()).all(), "low",
                 "a box needs low to be no higher than high, in each direction.");
}

void describe(auto& fields, Region& region) {
    fields.oneOf(region,
                 "expected either a ball (\"center\", \"radius\") or a box (\"low\", \"high\").");
}

void describe(auto& fields, StaticBox& box) {
    fields.required({"center", "The middle of the box [m]."}, box.center, kPositions);
    fields.required({"size", "Lengths of the sides along the box's own axes [m]."}, box.size,
                    kBoxSizes);
    fields.optional(kRotate, box.rotate, kTurns);
}

void describe(auto& fields, Placement& placement) {
    fields.optional(
        {"unit",
         "The unit of the model's numbers: m, cm, mm, um, km, in or ft. Metres where it "
         "is left out."},
        placement.unit, Words{kLengthUnitNames});
    fields.optional({"up",
                     "The axis of the model that points up: y, z, x, -y, -z or -x. It is turned to "
                     "+y; y where it is left out."},
                    placement.up, Words{kUpAxisNames});
    fields.optional({"scale", "Scales the model, before it is turned."}, placement.scale, kScales);
    fields.optional(kRotate, placement.rotate, kTurns);
    fields.optional({"translate", "Moves the model at last [m]."}, placement.translate, kPositions);
}

void describe(auto& fields, render::Camera& camera) {
    fields.required({"eye", "Where the camera is [m]."}, camera.eye, kPositions);
    fields.required({"target", "The point that it looks at [m]."}, camera.target, kPositions);
    fields.optional({"up", "The direction that is up in the picture."}, camera.up, kCoordinates);
    fields.optional({"fov_y", "The vertical field of view, in degrees."}, camera.fovY,
                    kFieldsOfView);
    fields.optional({"orthographic",
                     "Parallel rays: as high as the perspective picture at the "
                     "target."},
                    camera.orthographic);
    const Vec3 forward = camera.target - camera.eye;
    fields.check(forward.norm() != 0, "", "eye and target are the same point.");
    fields.check(camera.up.norm() != 0 && forward.cross(camera.up).norm() >=
                                              kLeastSineOfUp * forward.norm() * camera.up.norm(),
                 "up", "up must not point along the line of sight.");
}

// The events, in the order of SessionAction.

void describe(auto& fields, MoveBlade& move) {
    fields.type({"blade",
                 "A key pose of the blade. The first one places it; on the way to each further one "
                 "it cuts."});
    fields.required({"a", "One end of the blade [m]."}, move.blade.a, kPositions);
    fields.required({"b", "The other end of the blade [m]."}, move.blade.b, kPositions);
    fields.optional(
        {"seconds",
         "How long a hand took for each step to here, or was away before a further stroke. Films "
         "show it where time stands."},
        move.seconds, Limits{0, 3600});
    fields.check(move.blade.a != move.blade.b, "a",
                 "a and b are the same point; a blade needs a length.");
}

void describe(auto& fields, LiftBlade&) {
    fields.type({"lift", "Takes the blade away and ends the stroke."});
}

void describe(auto& fields, SetParam& set) {
    fields.type({"set", "Changes a parameter."});
    fields.param({"name", "The parameter."}, set.name, {"value", "Its new value."}, set.value);
    fields.optional({"continues", "One change with the set of this parameter before it."},
                    set.continues);
    fields.optional({"material",
                     "The label of the material that it belongs to: one change with the sets of it "
                     "just before."},
                    set.material, kLabels);
}

void describe(auto& fields, Grab& grab) {
    fields.type({"grab", "A hand takes hold of what lies about a point."});
    fields.optional(kHand, grab.hand, kHands);
    fields.required({"at", "The point [m]."}, grab.at, kPositions);
    fields.required({"radius", "How far about the point the hand reaches [m]."}, grab.radius,
                    kRadii);
    fields.optional({"surface", "How far along the surface, and of one side of a cut alone."},
                    grab.alongSurface);
    fields.optional({"continues", "One change with the grab before it."}, grab.continues);
}

void describe(auto& fields, Drag& drag) {
    fields.type({"drag", "A key pose of a hand, to which it moves with what it holds."});
    fields.optional(kHand, drag.hand, kHands);
    fields.required({"to", "Where the hand is then [m]."}, drag.to, kPositions);
}

void describe(auto& fields, Release& release) {
    fields.type({"release", "A hand lets go."});
    fields.optional(kHand, release.hand, kHands);
}

void describe(auto& fields, Pin& pin) {
    fields.type({"pin", "What is now in the ball or box stays where it is."},
                {"unpin", "What is now in the ball or box is free again."}, pin.pinned);
    describe(fields, pin.region);
    fields.optional({"continues", "One change with the pin or unpin before it."}, pin.continues);
    fields.optional({"velocity", "It does not stay there, but moves with this velocity [m/s]."},
                    pin.velocity, kSpeeds);
    fields.optional({"seconds", "For how long it moves; then it stays. For good if left out [s]."},
                    pin.seconds, kDurations);
    fields.check(pin.pinned || !pin.velocity, "velocity", "an unpin has no velocity.");
    fields.check(pin.velocity || !pin.seconds, "seconds", "seconds need a velocity.");
}

void describe(auto& fields, MovePins& move) {
    fields.type({"move_pins", "What is pinned is turned about its middle and moved, at once."});
    fields.required({"by", "How far it moves [m]."}, move.by, kCoordinates);
    fields.optional(kRotate, move.rotate, kTurns);
    fields.optional({"continues", "One change with the move_pins before it."}, move.continues);
}

void describe(auto& fields, ApplyForce& apply) {
    fields.type({"force",
                 "A force acts on what is now in the ball or box, shared by mass, until a force of "
                 "0 there takes it away."});
    describe(fields, apply.region);
    fields.required({"newtons", "The whole force [N]."}, apply.newtons, kForces);
    fields.optional(
        {"continues", "Widens the region of the force before it; one change with that."},
        apply.continues);
}

void describe(auto& fields, AddBox& add) {
    fields.type({"add_box", "Puts up a box, at the end of their list."});
    describe(fields, add.box);
}

void describe(auto& fields, ChangeBox& change) {
    fields.type({"change_box", "Puts a box elsewhere, at once."});
    fields.required({"box", "The number of the box, from 0."}, change.index, kBoxNumbers);
    describe(fields, change.box);
    fields.optional({"continues", "One change with the change_box before it."}, change.continues);
}

void describe(auto& fields, RemoveBox& remove) {
    fields.type({"remove_box", "Takes a box away. Those behind it in the list move up."});
    fields.required({"box", "The number of the box, from 0."}, remove.index, kBoxNumbers);
}

void describe(auto& fields, RemovePiece& remove) {
    fields.type({"remove_piece",
                 "Takes a piece away, with what holds or pulls it. Those behind it move up."});
    fields.required({"piece", "The number of the piece, from 0."}, remove.piece, kPieceNumbers);
}

void describe(auto& fields, Restart&) {
    fields.type({"restart", "The uncut body at rest, without blade, hands and pins."});
}

void describe(auto& fields, Place& place) {
    fields.type(
        {"place",
         "The uncut body at rest, as by restart, with its model placed otherwise. Keys that "
         "are left out mean what they mean in placement."});
    describe(fields, place.placement);
    fields.optional({"model", "The number of the model, from 0, where the scene has several."},
                    place.model, kModelNumbers);
    fields.optional({"continues", "One change with the place before it."}, place.continues);
}

void describe(auto& fields, Undo&) {
    fields.type({"undo", "Takes back the last change."});
}

void describe(auto& fields, Redo&) {
    fields.type({"redo", "Brings back what the last undo took."});
}

void describe(auto& fields, SetTime& time) {
    fields.type({"run", "Time runs again."},
                {"hold", "Time stands: the blade cuts the body where that lies."}, time.runs);
}

void describe(auto& fields, ScreenshotEvent& event) {
    fields.type({"screenshot", "Writes a picture."});
    fields.required({"file", "The picture, below the output folder: a .png."}, event.file,
                    OutputName{{".png"}});
    fields.optional({"width", "How wide it is [pixels]."}, event.width, kPictureSizes);
    fields.optional({"height", "How high it is [pixels]."}, event.height, kPictureSizes);
}

void describe(auto& fields, ExportEvent& event) {
    std::vector<std::string_view> endings;
    for (const MeshFormatInfo& format : meshFormats()) endings.push_back(format.extension);
    fields.type({"export", "Writes the mesh."});
    fields.required({"file", "The file, below the output folder. Its ending names the format."},
                    event.file, OutputName{endings});
    fields.optional({"per_piece", "A file for each piece."}, event.filePerPiece);
    fields.optional({"coordinates",
                     "model: those of the model's own file; scene: metres, +y up. Where it is left "
                     "out: model if the placement has a unit, else scene."},
                    event.coordinates, Words{kCoordinatesNames});
}

void describe(auto& fields, CheckEvent& event) {
    fields.type({"check", "What must be found, else the replay fails."});
    fields.optional({"hash", "The state hash: 16 lower-case hexadecimal digits."}, event.hash,
                    kStateHashDigits);
    fields.optional({"pieces", "The number of pieces."}, event.pieces, Limits{1, kMaxSteps});
    fields.atLeastOneOf({"hash", "pieces"}, "a check needs \"hash\" or \"pieces\".");
}

void describe(auto& fields, CameraEvent& event) {
    fields.type({"camera", "A key of the camera of films and strips."});
    describe(fields, event.camera);
}

void describe(auto& fields, MarkEvent& event) {
    fields.type({"mark", "A name for this place on the time line. Replays ignore it."});
    fields.required({"name", "What the time line shows."}, event.name, kLabels);
}

/// Calls `visit` with a default event of each kind, in the order of the variant.
template <class... Events, class Visit>
void forEachKind(std::type_identity<std::variant<Events...>>, Visit visit) {
    (visit(Events{}), ...);
}

}  // namespace kerf::app
