// One description of what a session consists of besides its events (event_table.h). Reader, writer
// and the schema for text editors are made from it. The parameters stand in sim/base/params.cpp.
#pragma once

#include "app/session/event_table.h"

namespace kerf::app {

/// The name of a builtin model.
struct BuiltinName {};
/// The name of a model file.
struct ModelPath {};

inline constexpr FileFormat kSessionFormat{"kerf-session", 1};

inline constexpr HexDigits kSha256Digits{64};
inline constexpr Limits kColorParts{0, 1};

/// The view of a session: the camera and, beside it, the colours.
struct SessionView {
    std::optional<render::Camera>& camera;
    render::ChosenColors& colors;
};

// describe(fields, item) as in event_table.h, with some fields that only a session has:
// - ignored(word): a key that is no mistake, and means nothing.
// - format(formatWord, versionWord, format): that this is a file of that format and version.
// - material(word, session): a material by name or file, which gives the session its values.
// - params(word, params): parameters by name.
// - list(word, items, most): at most so many items.
// - events(word, events, steps): what happens, each at one of these steps.
// - action(word, action): the type of an event, and what describe() says of it.

void describe(auto& fields, ModelReference& model) {
    fields.exactlyOneOf({"builtin", "path"}, "expected either \"builtin\" or \"path\".");
    fields.optional({"builtin", "The name of a model that comes with Kerf."}, model.builtin,
                    BuiltinName{});
    fields.optional({"path", "A model file, relative to the session file."}, model.path,
                    ModelPath{});
    fields.optional({"sha256",
                     "The SHA-256 that the file must have: 64 lower-case hexadecimal "
                     "digits."},
                    model.sha256, kSha256Digits);
    fields.optional({"object",
                     "The only object of the file that is taken, by its number from 1; all where "
                     "it is left out."},
                    model.object, kObjectNumbers);
    fields.optional({"fill_holes", "Fills holes before the model is cut."}, model.fillHoles);
    fields.optional({"repair", "Repairs the model before it is cut."}, model.repair);
    fields.optional({"remesh", "Makes its triangles even before it is cut."}, model.remesh);
    fields.optional({"remesh_edge",
                     "How long their edges are, in the unit of the file; as those of even "
                     "triangles with the same areas where it is left out."},
                    model.remeshEdge, kRadii);
}

void describe(auto& fields, FurtherModel& further) {
    describe(fields, further.model);
    fields.optional({"placement", "How its numbers become metres, and where it lies."},
                    further.placement);
    fields.optional({"color",
                     "Colour of its skin where the file brings none: red, green and blue, 0 to 1 "
                     "as displays take them."},
                    further.color, kColorParts);
}

void describe(auto& fields, SessionEvent& event, const Limits& steps) {
    fields.required({"step",
                     "The event applies before this step; after the last one where it is "
                     "the number of steps."},
                    event.step, steps);
    fields.action({kTypeKey, "What happens."}, event.action);
}

void describe(auto& fields, render::ChosenColors& colors) {
    fields.optional({"look",
                     "What the body looks made of, faces of cuts included, instead of the model's "
                     "own look."},
                    colors.look, Words{render::kLookWords});
    fields.optional({"skin",
                     "Colour of the skin: red, green and blue, 0 to 1 as displays take "
                     "them."},
                    colors.skin, kColorParts);
    fields.optional({"flesh", "Colour of the faces of cuts: red, green and blue, 0 to 1."},
                    colors.flesh, kColorParts);
    fields.optional({"of_look",
                     "Whether the skin shows the colours of the look, even where the model's file "
                     "has colours or images of its own."},
                    colors.ofLook);
}

void describe(auto& fields, SessionView& view) {
    describe(fields, view.camera ? *view.camera : view.camera.emplace());
    describe(fields, view.colors);
}

void describe(auto& fields, Session& session) {
    SessionView view{session.view, session.colors};
    fields.ignored({"$schema", "The schema by which an editor checks this file. Kerf ignores it."});
    fields.format({"format", "Says that this is a session."},
                  {"version", "The version of the format."}, kSessionFormat);
    fields.required({"model", "What is cut."}, session.model);
    fields.optional({"placement",
                     "How the model's numbers become metres, and where it lies: scaled, turned, "
                     "then moved."},
                    session.placement);
    fields.list(
        {"more_models", "Further models of the scene, numbered from 1; model 0 is the one above."},
        session.moreModels, kMostModels - 1);
    fields.material(
        {"material",
         "What the body is made of: the name of a material that comes with Kerf, or a "
         "file relative to the session (.json). It gives the parameters that are not in "
         "params, and a look where the view has none."},
        session);
    fields.params(
        {"params", "The parameters at the start. One left out has its default, or the material's."},
        session.params);
    fields.list({"boxes", "What the body collides with besides the floor."}, session.boxes,
                kMostBoxes);
    fields.required({"steps", "How many steps to run."}, session.steps, Limits{1, kMaxSteps});
    fields.events({"events", "What happens, before which step."}, session.events,
                  Limits{0, static_cast<double>(session.steps)});
    fields.optional({"view",
                     "The camera, and colours instead of the model's own. Without it the "
                     "model is seen from the front right above."},
                    view);
}

}  // namespace kerf::app
