// How bodies keep volume and shape where they fall: the paper's five models, whole and cut in half,
// dropped from half a metre with their time steps, with pbd with their iterations too. Not part of
// scripts/bench, as it measures no times.
//
//   kerf_drop_bench [--only TEXT] [--solver pbd] [--ispc S] [--modulus E] [--seconds T]
//       [--iterations N] [--bending B] [--contact 0]
//       [--azimuth DEGREES]

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "app/files/import/builtin_models.h"
#include "app/files/import/model_source.h"
#include "app/session/paper_experiments.h"
#include "gpu/context.h"
#include "tests/support/drop_scene.h"
#include "tests/support/shapes.h"

namespace kerf::test {
namespace {

using Options = std::map<std::string, std::string>;

Options readOptions(int count, char** words) {
    Options options;
    for (int i = 1; i + 1 < count; i += 2) {
        options[words[i]] = words[i + 1];
    }
    return options;
}

double number(const Options& options, const std::string& name, double otherwise) {
    const auto at = options.find(name);
    return at == options.end() ? otherwise : std::atof(at->second.c_str());
}

struct DropModel {
    std::string name;
    double timeStep;  ///< [s]
    int paperIterations;
    double modulus;  ///< Young's [Pa]
    SurfaceMesh mesh;
};

/// The paper's models with its time steps and iterations, and one more resolution of the sphere.
/// Half of the octopus's head stands on half of its neck, which buckles below 3.7e5 Pa
/// (docs/physics.md): it takes a stiffer material.
std::vector<DropModel> dropModels() {
    std::vector<DropModel> models;
    for (const app::PaperExperiment& paper : app::paperExperiments()) {
        DropModel model{paper.name, paper.timeStep, paper.iterations, 1e5,
                        app::loadModel(app::builtinModelFile(paper.name))};
        if (model.name == "banana") {
            model.modulus = 5e5;
        } else if (model.name == "octopus") {
            model.modulus = 6e5;
        }
        models.push_back(std::move(model));
    }
    models.push_back({"sphere12288", 0.005, 20, 1e5, cubeSphere(32)});
    return models;
}

void play(const DropModel& model, bool cut, const Options& options) {
    const std::string name = model.name + (cut ? " cut" : " whole");
    const auto only = options.find("--only");
    if (only != options.end() && name.find(only->second) == std::string::npos) {
        return;
    }
    DropScene scene;
    Params& params = scene.params;
    scene.cut = cut;
    scene.azimuth = number(options, "--azimuth", 0) * std::numbers::pi / 180;
    scene.seconds = number(options, "--seconds", 3);
    params.timeStep = model.timeStep;
    params.youngsModulus = number(options, "--modulus", model.modulus);
    params.ispcStiffness = number(options, "--ispc", params.ispcStiffness);
    params.bendingStiffness = number(options, "--bending", params.bendingStiffness);
    params.contact = number(options, "--contact", 1) != 0 ? 1 : 0;
    const bool pbd = options.count("--solver") > 0 && options.at("--solver") == "pbd";
    params.iterations = static_cast<int>(
        number(options, "--iterations", pbd ? model.paperIterations : kAutoIterations));
    params.solver = pbd ? SolverMode::pbd : SolverMode::implicit;
    std::fputs(dropTableRow(name, playDrop(model.mesh, scene)).c_str(), stdout);
    std::fflush(stdout);
}

}  // namespace
}  // namespace kerf::test

int main(int count, char** words) {
    try {
        const kerf::gpu::EglContext context;
        const auto options = kerf::test::readOptions(count, words);
        std::fputs(kerf::test::dropTableHead().c_str(), stdout);
        for (const kerf::test::DropModel& model : kerf::test::dropModels()) {
            for (const bool cut : {false, true}) {
                kerf::test::play(model, cut, options);
            }
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
