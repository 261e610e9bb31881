// One description of what a session consists of besides its events (event_table.h). Reader, writer
// and the schema for text editors are made from it. The parameters stand in sim/base/params.cpp.
//
// One description of what a material file consists of. Reader, writer and the schema for text
// editors are made from it, as of session_table.h, whose words mean the same here.
#pragma once

#include "app/session/event_table.h"
#include "app/session/material.h"

namespace kerf::app {

/// The name of a builtin model.
struct BuiltinName {};
/// The name of a model file.
struct ModelPath {};

inline constexpr FileFormat kSessionFormat{"kerf-session", 1};

inline constexpr HexDigits kSha256Digits{64};
inline constexpr Limits kColorParts{0, 1};
inline constexpr Limits kShares{0, 1};
inline constexpr std::size_t kMostShownPieces = 100'000;
inline constexpr Limits kCosines = within(1 + 1e-6);
inline constexpr double kLengthError = 1e-6;
inline constexpr Limits kDistances{0, kMaxSessionCoordinate};  // [m]
inline constexpr double kLeastSineOfInto = 0.1;                // between it and a line

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
    fields.optional({"thicken",
                     "The thickness that open sheets are given before the model is cut, in the "
                     "unit of the file."},
                    model.thicken, kRadii);
    fields.optional({"remesh", "Makes its triangles even before it is cut."}, model.remesh);
    fields.optional({"remesh_edge",
                     "How long their edges are, in the unit of the file; as those of even "
                     "triangles with the same areas where it is left out."},
                    model.edge, kRadii);
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

void describe(auto& fields, render::SectionPlane& plane) {
    fields.required({"point", "A point on the plane [m]."}, plane.point, kPositions);
    fields.required({"normal", "Points to the side that is hidden; of length 1."}, plane.normal,
                    kCosines);
    fields.check(std::abs(plane.normal.norm() - 1) < kLengthError, "normal", "expected length 1.");
}

void describe(auto& fields, ShownPiece& piece) {
    fields.optional({"hidden", "Whether it is not drawn."}, piece.hidden);
    fields.optional({"color", "Its colour instead of its look: red, green and blue, 0 to 1."},
                    piece.color, kColorParts);
}

void describe(auto& fields, SavedView& view) {
    fields.required({"camera", "Where it was seen from."}, view.camera);
    fields.optional({"tool", "The tool in hand: Stroke, Scalpel, Grab and so on."}, view.tool,
                    kLabels);
    fields.optional({"field", "The quantity that colours show: Strain, Thickness and so on."},
                    view.field, kLabels);
    fields.optional({"wireframe", "Whether the triangles' edges are drawn."}, view.wireframe);
    fields.optional({"apart", "How far the pieces are drawn from each other; 0 is together."},
                    view.apart, kShares);
    fields.optional({"section", "The plane at which the body is opened for the view."},
                    view.section);
    fields.list({"pieces", "The first pieces, by number; the others look as always."}, view.pieces,
                kMostShownPieces);
}

void describe(auto& fields, TaskLine& line) {
    fields.required({"points", "Where it runs: two points at least [m]."}, line.points, kPositions);
    fields.optional({"closed", "The last point is joined to the first."}, line.closed);
    const std::vector<Vec3>& points = line.points;
    fields.check(points.size() >= 2, "points", "a line has two points at least.");
    fields.check(std::ranges::adjacent_find(points) == points.end() &&
                     !(line.closed && points.front() == points.back()),
                 "points", "two points in a row are the same.");
}

void describe(auto& fields, TaskLimits& limits) {
    fields.optional({"deviation", "How far the rim may be from the line, at most [m]."},
                    limits.deviation, kDistances);
    fields.optional({"deviation_mean", "How far it may be from the line on average, at most [m]."},
                    limits.meanDeviation, kDistances);
    fields.optional({"ends",
                     "How much of the lines may be left uncut, and how long a cut beside or beyond "
                     "them may be, at most [m]."},
                    limits.ends, kDistances);
    fields.optional({"in_band", "The share of the cut whose depth is within the band, at least."},
                    limits.inBand, kShares);
    fields.optional({"margin", "Between cuts and what is spared, at least [m]."}, limits.margin,
                    kDistances);
    fields.optional({"seconds", "The time that it may take, at most [s]."}, limits.seconds,
                    kDurations);
    fields.optional({"idle", "The time at rest and between strokes, at most [s]."}, limits.idle,
                    kDurations);
    fields.optional({"economy", "The expert's path over that of the hand, at least."},
                    limits.economy, kShares);
    fields.optional({"smoothness", "The log dimensionless jerk, at least."}, limits.smoothness,
                    within(100));
    fields.optional({"wobble", "The hand's way to and fro beside the line, at most [m]."},
                    limits.wobble, kDistances);
    fields.optional({"newtons", "The force on the blade, at most [N]."}, limits.newtons,
                    Limits{0, kForces.high});
}

void describe(auto& fields, Task& task) {
    fields.required({"name", "What the task is called."}, task.name, kLabels);
    fields.optional({"about", "What to do, in a sentence or two."}, task.about, ShortText{300});
    fields.optional({"expert", "A session beside this one whose blade shows how it is done."},
                    task.expert, ModelPath{});
    fields.list({"lines", "Along which to cut."}, task.lines, kMostOfTask);
    fields.optional({"model", "The number of the model to cut."}, task.model, kModelNumbers);
    fields.optional({"into", "The direction into the body, along no line."}, task.into,
                    kCoordinates);
    fields.optional({"reach", "What is farther aside does not belong to a line [m]."}, task.reach,
                    kRadii);
    fields.optional({"depth", "How deep to cut; through where it is left out [m]."}, task.depth,
                    kRadii);
    fields.optional({"band", "By how much the depth may differ [m]."}, task.band, kDistances);
    fields.optional({"spare", "The numbers of models that must not be cut."}, task.spare,
                    kModelNumbers);
    fields.list({"spare_regions", "Balls and boxes at rest that must not be cut."},
                task.spareRegions, kMostOfTask);
    fields.optional({"take", "The number of a model to be taken out whole."}, task.take,
                    kModelNumbers);
    fields.optional({"path", "How far the expert's hand moves, for the economy [m]."}, task.path,
                    kRadii);
    describe(fields, task.limits);
    fields.optional({"person", "Of a try: who."}, task.person, kLabels);
    fields.optional({"date", "Of a try: when."}, task.date, kLabels);
    fields.check(!task.lines.empty() || task.take, "",
                 "there is nothing to do; give lines, or a model to take.");
    for (const TaskLine& line : task.lines) {
        for (std::size_t i = 1; i < line.points.size() + (line.closed ? 1 : 0); ++i) {
            const Vec3 along = line.points[i % line.points.size()] - line.points[i - 1];
            fields.check(
                along.cross(task.into).norm() >= kLeastSineOfInto * along.norm() * task.into.norm(),
                "into", "it points along a line; give a direction into the body.");
        }
    }
    fields.check(!task.into.isZero(0), "into", "it has no direction.");
    fields.check(!task.limits.economy || task.path, "economy", "it needs the `path` of an expert.");
    fields.check(!task.limits.inBand || (task.depth && task.band > 0), "in_band",
                 "it needs a `depth` and a `band` about it.");
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
        session);
    fields.list({"boxes", "What the body collides with besides the floor."}, session.boxes,
                kMostBoxes);
    fields.optional({"task", "What to practise, and how well it must be done (docs/practice.md)."},
                    session.task);
    fields.required({"steps", "How many steps to run."}, session.steps, Limits{1, kMaxSteps});
    fields.events({"events", "What happens, before which step."}, session.events,
                  Limits{0, static_cast<double>(session.steps)});
    fields.optional({"view",
                     "The camera, and colours instead of the model's own. Without it the "
                     "model is seen from the front right above."},
                    view);
    fields.optional({"editor",
                     "What the editor showed when it saved the session, and shows when it opens "
                     "it. Replays ignore it."},
                    session.editor);
}

inline constexpr FileFormat kMaterialFormat{"kerf-material", 1};
inline constexpr ShortText kNotes{400};
inline constexpr Limits kSpreads{0, 1e12};

/// The names of the properties, which sources refer to.
inline std::span<const std::string_view> propertyNames() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> collected;
        std::ranges::transform(materialProperties(), std::back_inserter(collected),
                               &MaterialProperty::name);
        return collected;
    }();
    return names;
}

void describe(auto& fields, MaterialValue& value, const Limits& limits = {}) {
    fields.required({"value", "A typical value."}, value.value, limits);
    fields.optional({"low", "The lower end of what is measured."}, value.low, kSpreads);
    fields.optional({"high", "The upper end."}, value.high, kSpreads);
    fields.check(value.low.has_value() == value.high.has_value(), "",
                 "a spread needs both \"low\" and \"high\".");
    fields.check(!value.low || *value.low <= *value.value, "low", "low must not be above value.");
    fields.check(!value.high || *value.high >= *value.value, "high",
                 "high must not be below value.");
}

void describe(auto& fields, MaterialSource& source) {
    fields.required({"of", "The values that it is about."}, source.of, Words{propertyNames()});
    fields.required({"text", "Authors, year, title, journal, table; or the reason of an estimate."},
                    source.text, kNotes);
    fields.optional({"says", "What stands there."}, source.says, kNotes);
    fields.optional({"doi", "Its DOI, without https://doi.org/."}, source.doi, kNotes);
    fields.optional({"estimate", "Whether this is an estimate that nobody has measured."},
                    source.estimate);
}

void describe(auto& fields, Material& material) {
    fields.ignored({"$schema", "The schema by which an editor checks this file. Kerf ignores it."});
    fields.format({"format", "Says that this is a material."},
                  {"version", "The version of the format."}, kMaterialFormat);
    fields.optional({"label", "What people read. The file's name where it is left out."},
                    material.label, kLabels);
    fields.optional({"about", "What exactly it is."}, material.about, kNotes);
    for (const MaterialProperty& property : materialProperties()) {
        fields.optional({property.name, property.meaning}, material.*property.member,
                        Limits{property.low, property.high});
    }
    fields.atLeastOneOf({"youngs_modulus", "density", "friction", "damping"},
                        "a material needs \"youngs_modulus\", \"density\", \"friction\" or "
                        "\"damping\".");
    fields.optional({"look", "What it looks like, as in the view of a session."}, material.colors);
    fields.list({"sources", "Where the values come from."}, material.sources, kMostSources);
}

}  // namespace kerf::app
