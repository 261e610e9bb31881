#include "app/scene/editor_document.h"

#include <cstdio>
#include <string_view>

#include "gpu/data_path.h"
#include "sim/base/text.h"
#include "sim/mesh/invariants.h"

namespace kerf::app {
namespace {

constexpr double kFloorGap = 0.02;  // of the diagonal
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

std::string modelNote(const MeshReport& report, double scale) {
    char text[64];
    std::snprintf(text, sizeof text, "Scaled by %.4g to fit the view.", scale);
    const std::string repairs = joined(report.repairs, "; ");
    return repairs.empty() ? text : std::string(text) + " Repaired: " + repairs + ".";
}

Document finish(std::string name, Session session, ModelMesh model, std::string note) {
    const Bounds bounds = meshBounds(model.mesh);
    const render::Camera camera = sessionCamera(session, bounds);
    return {std::move(name), std::move(session),   std::move(model.mesh), bounds,
            camera,          std::move(model.uvs), std::move(note)};
}

Document openModel(const std::filesystem::path& file, const ReadOptions& options) {
    MeshReport report;
    ReadOptions ours = options;
    ours.report = &report;
    ModelMesh model = readModel(file, ours);
    Session session;
    session.model.path = std::filesystem::absolute(file);
    session.model.fillHoles = options.fillHoles;
    session.placement = fitPlacement(meshBounds(model.mesh), kModelDiagonal);
    place(model.mesh, session.placement);
    std::string note = modelNote(report, session.placement.scale);
    return finish(shortName(file), std::move(session), std::move(model), std::move(note));
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

Placement fitPlacement(const Bounds& bounds, double diagonal) {
    Placement placement;
    if (bounds.diagonal() > 0) {
        placement.scale = diagonal / bounds.diagonal();
    }
    const Vec3 center = bounds.center();
    placement.translate = -placement.scale * Vec3(center.x(), bounds.low.y(), center.z());
    placement.translate.y() += kFloorGap * diagonal;
    return placement;
}

}  // namespace kerf::app
