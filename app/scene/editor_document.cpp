#include "app/scene/editor_document.h"

#include <string_view>

#include "gpu/data_path.h"
#include "sim/base/size_params.h"
#include "sim/base/text.h"
#include "sim/mesh/invariants.h"

namespace kerf::app {
namespace {

constexpr std::string_view kSessionEnding = ".kerf.json";

bool isSession(const std::filesystem::path& file) {
    return lowerCase(file.extension().string()) == ".json";
}

std::string shortName(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (name.ends_with(kSessionEnding)) {
        return name.substr(0, name.size() - kSessionEnding.size());
    }
    return file.stem().string();
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
    return {std::move(name), std::move(session),     std::move(model.mesh), bounds,
            camera,          std::move(model.looks), std::move(note),       {}};
}

Document openModel(const std::filesystem::path& file, const ReadOptions& options) {
    MeshReport report;
    ReadOptions ours = options;
    ours.report = &report;
    ModelMesh model = readModel(file, ours);
    Session session;
    session.model.path = std::filesystem::absolute(file);
    session.model.fillHoles = options.fillHoles;
    const UnitGuess guess = guessUnits(file, meshBounds(model.mesh));
    session.placement = standing(guess, model.mesh.restPositions());
    place(model.mesh, session.placement);
    const Bounds placed = meshBounds(model.mesh);
    if (const std::string problem = checkRoom(placed); !problem.empty()) {
        throw InputError(file.string() + ": " + problem);
    }
    session.params = suitedTo(placed.diagonal(), session.params);
    Document document =
        finish(shortName(file), std::move(session), std::move(model), modelNote(report, guess));
    document.guess = guess;
    return document;
}

Document openSession(const std::filesystem::path& file, const ReadOptions& options) {
    Session session = readSession(file);
    session.model.fillHoles |= options.fillHoles;
    ModelMesh model = loadSessionModel(session, options);
    std::string note = joined(session.warnings, "; ");
    return finish(shortName(file), std::move(session), std::move(model), std::move(note));
}

}  // namespace

Document openDocument(const std::filesystem::path& file, const ReadOptions& options) {
    return isSession(file) ? openSession(file, options) : openModel(file, options);
}

Document openDefaultDocument() {
    return openSession(gpu::dataPath("assets/sessions/drop-in.kerf.json"), {});
}

}  // namespace kerf::app
