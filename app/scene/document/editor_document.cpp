#include "app/scene/document/editor_document.h"

#include "app/files/io/encodings.h"
#include "app/session/material.h"
#include "app/session/scene_origin.h"
#include "sim/base/size_params.h"
#include "sim/base/text.h"
#include "sim/mesh/invariants.h"

namespace kerf::app {

namespace {

/// What is unreadable now may be readable again, and the loading will say so if not.
std::string hashOf(const std::filesystem::path& file) {
    try {
        return sha256OfFile(file);
    } catch (const InputError&) {
        return "";
    }
}

constexpr double kGapBeside = 0.1;  // between models of a scene, of the larger diagonal
bool isJson(const std::filesystem::path& file) {
    return lowerCase(file.extension().string()) == ".json";
}

std::string modelNote(const MeshReport& report, const UnitGuess& guess) {
    const std::string repairs = joined(report.repairs, "; ");
    return repairs.empty() ? guess.sentence : guess.sentence + " Repaired: " + repairs + ".";
}

Document finish(std::string name, Session session, ModelMesh model, std::string note) {
    const Bounds bounds = meshBounds(model.mesh);
    const render::Camera camera = sessionCamera(session, bounds);
    for (const std::string& remark : model.remarks) {
        note += (note.empty() ? "" : " ") + remark;
    }
    Document document{std::move(name),
                      std::move(session),
                      std::move(model.mesh),
                      bounds,
                      camera,
                      std::move(model.looks),
                      std::move(note),
                      std::nullopt,
                      std::move(model.placed),
                      std::move(model.faults),
                      std::move(model.facts.objects)};
    for (const std::filesystem::path& file : modelFiles(document.session)) {
        document.read[file] = {stampOf(file), hashOf(file)};
    }
    return document;
}

/// A new model is of soft silicone, as models that are made to be cut: it carries every size that
/// guessUnits() leaves, and yields to a hand. What has colours of its own keeps them.
void giveMaterial(Session& session, const OwnLooks& looks) {
    const Material material = findMaterial(kMaterialOfNewModel, {});
    applyMaterial(session.params, material);
    session.material = material.name;
    session.colors = looks.colored() ? session.colors : material.colors;
}

Document openModel(const std::filesystem::path& file, const ReadOptions& options) {
    MeshReport report;
    ReadOptions ours = options;
    ours.report = &report;
    ModelMesh model = readModel(file, ours);
    Session session;
    session.model.path = std::filesystem::absolute(file);
    session.model.add(options);
    const UnitGuess guess = guessUnits(file, meshBounds(model.mesh), model.facts.units);
    session.placement = standing(guess, model.mesh.restPositions());
    place(model.mesh, session.placement);
    model.placed = {{session.placement, 0}};
    const Bounds placed = meshBounds(model.mesh);
    if (const std::string problem = checkRoom(placed); !problem.empty()) {
        throw InputError(file.string() + ": " + problem);
    }
    session.params = ofNewScene(session.params);
    giveMaterial(session, model.looks);
    session.params = suitedTo(placed.diagonal(), session.params);
    Document document =
        finish(shortName(file), std::move(session), std::move(model), modelNote(report, guess));
    document.guess = guess;
    return document;
}

Document openSession(const std::filesystem::path& file, const ReadOptions& options) {
    Session session = readSession(file);
    session.model.add(options);
    for (FurtherModel& further : session.moreModels) {
        further.model.add(options);
    }
    ModelMesh model = loadSessionModel(session, options);
    session = withOrigin(std::move(session), model.origin);
    std::string note = joined(session.warnings, "; ");
    Document document =
        finish(shortName(file), std::move(session), std::move(model), std::move(note));
    document.file = std::filesystem::absolute(file).lexically_normal();
    return document;
}

/// On the floor, at the right of the others.
Placement beside(const Bounds& others, const Placement& placement, const std::vector<Vec3>& own) {
    const Bounds placed = placedBounds(own, placement);
    const double half = 0.5 * (placed.high - placed.low).x();
    const double gap = kGapBeside * std::max(placed.diagonal(), others.diagonal());
    return standing(placement, own,
                    {others.high.x() + gap + half, others.low.y(), others.center().z()});
}

/// With a colour of its own, so that models that bring none can be told apart.
FurtherModel furtherModel(std::size_t number) {
    static const std::array<Vec3, 5> kColors{{{0.36, 0.62, 0.80},
                                              {0.55, 0.72, 0.38},
                                              {0.86, 0.60, 0.28},
                                              {0.66, 0.48, 0.74},
                                              {0.80, 0.44, 0.46}}};
    FurtherModel further;
    further.color = kColors[(number - 1) % kColors.size()];
    return further;
}

}  // namespace

std::string shortName(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (name.ends_with(kSessionEnding)) {
        return name.substr(0, name.size() - kSessionEnding.size());
    }
    return file.stem().string();
}

Session parted(Session scene, int objects) {
    scene.model.object = 1;
    for (int object = 2; object <= objects; ++object) {
        FurtherModel further = furtherModel(scene.moreModels.size() + 1);
        further.model = scene.model;
        further.model.object = object;
        further.placement = scene.placement;
        scene.moreModels.push_back(std::move(further));
    }
    return scene;
}

MemoryNeed memoryNeedOf(const Document& document) {
    const Session& session = document.session;
    MemorySettings settings = memorySettings(session.params, !session.boxes.empty());
    settings.undoBudget = kUndoBudget;
    settings.checkpointBudget = kCheckpointBudget;
    return memoryNeedOf(BodySize::ofMesh(document.mesh), settings);
}

std::vector<std::filesystem::path> changedModels(const Document& document) {
    std::vector<std::filesystem::path> changed;
    for (const auto& [file, read] : document.read) {
        if (stampOf(file) != read.stamp) {
            changed.push_back(file);
        }
    }
    return changed;
}

Document openScene(const std::string& name, Session scene, const ReadOptions& options) {
    ModelMesh models = loadSessionModel(scene, options);
    scene = withOrigin(std::move(scene), models.origin);
    Document document = finish(name, std::move(scene), std::move(models), "");
    document.inFile = false;
    return document;
}

namespace {

/// Adds the model of a file at the right of `before`, the box of what is there [m], which grows by
/// it. Returns what is to be told of it.
std::string addBeside(Session& scene, Bounds& before, const std::filesystem::path& file,
                      const ReadOptions& options) {
    const std::size_t count = scene.moreModels.size() + 1;
    if (isJson(file)) {
        throw InputError(file.filename().string() +
                         ": a session can't be added to a scene; add its model file instead.");
    }
    if (count >= kMostModels) {
        throw InputError("A scene can hold at most " + std::to_string(kMostModels) +
                         " models; remove one before you add another.");
    }
    MeshReport report;
    ReadOptions ours = options;
    ours.report = &report;
    const ModelMesh read = readModel(file, ours);
    const auto own = read.mesh.restPositions();
    const UnitGuess guess = guessUnits(file, meshBounds(read.mesh), read.facts.units);
    FurtherModel added = furtherModel(count);
    added.model.path = std::filesystem::absolute(file);
    added.model.add(options);
    added.placement = beside(before, standing(guess, own), own);
    before.add(placedBounds(own, added.placement));
    scene.moreModels.push_back(std::move(added));
    return "Added as model " + std::to_string(count) + ". " + modelNote(report, guess);
}

/// A scene whose models were read as `options` say, and are mended as it says itself.
Document openAdded(const std::string& name, Session scene, const ReadOptions& options) {
    ReadOptions all;
    all.findFaults = options.findFaults;
    all.findCrossingsUpTo = options.findCrossingsUpTo;
    return openScene(name, std::move(scene), all);
}

}  // namespace

Document openWithModel(const std::string& name, Session scene, const std::filesystem::path& file,
                       double right, const ReadOptions& options) {
    const ModelMesh there = loadSessionModel(scene, {});
    right += scene.origin.x() - there.origin.x();
    scene = withOrigin(std::move(scene), there.origin);
    Bounds before = meshBounds(there.mesh);
    before.high.x() = std::max(before.high.x(), right);
    const std::string note = addBeside(scene, before, file, options);
    Document document = openAdded(name, std::move(scene), options);
    document.note = note;
    return document;
}

Document openModels(const std::vector<std::filesystem::path>& files, const ReadOptions& options) {
    Document first = openDocument(files.front(), options);
    Bounds before = meshBounds(first.mesh);
    for (const std::filesystem::path& file : std::span(files).subspan(1)) {
        addBeside(first.session, before, file, options);
    }
    return openAdded(first.name, std::move(first.session), options);
}

Document openDocument(const std::filesystem::path& file, const ReadOptions& options) {
    return isJson(file) ? openSession(file, options) : openModel(file, options);
}

}  // namespace kerf::app
