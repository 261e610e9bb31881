// What becomes of models as people have them: cuttable at once, after a repair, or refused with a
// sentence; and what three cuts make of those that can be cut. Arguments are files, or folders that
// are searched for models. Prints a JSON object per model, and the sums. "--write-spoilt FOLDER"
// writes a ball with each defect of tests/support, alone and with each other one, instead.

#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/files/import/model_source.h"
#include "app/files/io/file_io.h"
#include "sim/base/math.h"
#include "sim/base/stopwatch.h"
#include "sim/mesh/invariants.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/model_defects.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kMostTriangles = 60'000;
constexpr int kSteps = 24;

/// What came of it, and what there is to say about it.
struct Outcome {
    std::string kind;  ///< "at once", "filled", "repaired", "refused", "unreadable"
    std::string sentence;
    std::string cut;  ///< "" where it is sound, else what is wrong
    int refusedSteps = 0;
    double seconds = 0;
};

void placeAtOrigin(SurfaceMesh& mesh) {
    const Bounds bounds = meshBounds(mesh);
    const double scale = 1 / std::max(bounds.diagonal(), 1e-300);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 at = scale * (mesh.restPosition(v) - bounds.center());
        const Vec3 rounded = nearestFloats(at);
        mesh.setPosition(v, rounded);
        mesh.setRestPosition(v, rounded);
    }
}

/// Cuts a copy across each axis.
void cutThrice(const SurfaceMesh& whole, Outcome& outcome) {
    for (int axis = 0; axis < 3 && outcome.cut.empty(); ++axis) {
        SurfaceMesh mesh = whole;
        const Vec3 along = Vec3::Unit((axis + 1) % 3);
        const Vec3 travel = Vec3::Unit((axis + 2) % 3);
        const test::CutCheck check = test::runStroke(
            mesh, test::exactSettings(),
            test::straightStroke(Vec3(0.0123, 0.0171, 0.0093), along, travel, 3, 2.2, kSteps));
        outcome.refusedSteps += check.refused;
        outcome.cut = check.problem;
    }
}

Outcome outcomeOf(const fs::path& file) {
    Outcome outcome;
    app::ReadOptions options;
    options.tryRepair = true;
    try {
        std::optional<app::ModelMesh> model;
        try {
            model = app::readModel(file, options);
            outcome.kind = "at once";
        } catch (const app::ModelFault& fault) {
            outcome.kind = "refused";
            outcome.sentence = fault.what();
            if (fault.help().holes > 0 || !fault.help().repairs.empty()) {
                options.fillHoles = fault.help().holes > 0;
                options.repair = !options.fillHoles;
                model = app::readModel(file, options);
                outcome.kind = options.fillHoles ? "filled" : "repaired";
            }
        }
        if (model && model->mesh.aliveTriangles() <= kMostTriangles) {
            placeAtOrigin(model->mesh);
            cutThrice(model->mesh, outcome);
        }
    } catch (const app::InputError& error) {
        outcome.kind = outcome.kind.empty() ? "unreadable" : outcome.kind;
        outcome.sentence = error.what();
    }
    return outcome;
}

void print(const std::string& name, const Outcome& outcome) {
    const Json line = {{"model", name},
                       {"kind", outcome.kind},
                       {"cut", outcome.cut},
                       {"refused_steps", outcome.refusedSteps},
                       {"seconds", outcome.seconds},
                       {"sentence", outcome.sentence}};
    std::puts(line.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
    std::fflush(stdout);
}

std::vector<fs::path> modelsIn(const fs::path& path) {
    std::vector<fs::path> files;
    if (!fs::is_directory(path)) {
        return {path};
    }
    for (const auto& entry : fs::recursive_directory_iterator(path)) {
        if (entry.is_regular_file() && app::isModelFile(entry.path())) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

/// Writes the spoilt balls into a folder.
void writeSpoilt(const fs::path& folder) {
    fs::create_directories(folder);
    int number = 0;
    const auto write = [&](const std::string& name, const TriangleSoup& soup) {
        TriangleSoup inRange = soup;
        std::erase_if(inRange.triangles, [&](const Triangle& t) {
            return std::ranges::any_of(
                t, [&](int v) { return v >= static_cast<int>(soup.positions.size()); });
        });
        std::string file = std::to_string(1000 + number++) + " " + name;
        app::writeOutputFile(folder / (file + ".obj"), test::objText(inRange));
    };
    for (const auto& [first, spoil] : test::modelDefects()) {
        TriangleSoup soup = test::soundBall();
        spoil(soup);
        write(first, soup);
        for (const auto& [second, spoilMore] : test::modelDefects()) {
            TriangleSoup both = soup;
            spoilMore(both);
            write(std::string(first).append(" + ").append(second), both);
        }
    }
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
    using namespace kerf;
    if (argc == 3 && std::string(argv[1]) == "--write-spoilt") {
        writeSpoilt(argv[2]);
        return 0;
    }
    std::map<std::string, int> sums;
    try {
        for (int i = 1; i < argc; ++i) {
            for (const fs::path& file : modelsIn(argv[i])) {
                const Stopwatch watch;
                Outcome outcome = outcomeOf(file);
                outcome.seconds = watch.seconds();
                print(file.string(), outcome);
                ++sums[outcome.cut.empty() ? outcome.kind : "wrong"];
            }
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    std::puts(Json(sums).dump().c_str());
    return 0;
}
