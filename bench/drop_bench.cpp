// How bodies keep volume and shape where they fall: the paper's five models, whole and cut in half,
// dropped from half a metre with their time steps and iterations. Not part of scripts/bench, as it
// measures no times.
//
//   kerf_drop_bench [--only TEXT] [--solver pbd] [--ispc S] [--modulus E] [--seconds T]
//       [--iterations N] [--bending B]

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>

#include "app/model_source.h"
#include "app/paper_experiments.h"
#include "gpu/context.h"
#include "tests/support/drop_scene.h"

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

/// Young's modulus of the shipped session [Pa].
double modulusOf(const std::string& model) {
    return model == "banana" ? 5e5 : model == "octopus" ? 3e5 : 1e5;
}

void play(const app::PaperExperiment& paper, bool cut, const Options& options) {
    const std::string name = std::string(paper.name) + (cut ? " cut" : " whole");
    const auto only = options.find("--only");
    if (only != options.end() && name.find(only->second) == std::string::npos) {
        return;
    }
    DropScene scene;
    scene.cut = cut;
    scene.seconds = number(options, "--seconds", 3);
    scene.params.timeStep = paper.timeStep;
    scene.params.iterations = static_cast<int>(number(options, "--iterations", paper.iterations));
    scene.params.youngsModulus = number(options, "--modulus", modulusOf(paper.name));
    scene.params.ispcStiffness = number(options, "--ispc", scene.params.ispcStiffness);
    scene.params.bendingStiffness = number(options, "--bending", scene.params.bendingStiffness);
    scene.params.solver = options.count("--solver") > 0 && options.at("--solver") == "pbd"
                              ? SolverMode::pbd
                              : SolverMode::smallSteps;
    const DropFigures figures = playDrop(app::loadModel(app::builtinModelFile(paper.name)), scene);
    std::fputs(dropTableRow(name, figures).c_str(), stdout);
    std::fflush(stdout);
}

}  // namespace
}  // namespace kerf::test

int main(int count, char** words) {
    try {
        const kerf::gpu::EglContext context;
        const auto options = kerf::test::readOptions(count, words);
        std::fputs(kerf::test::dropTableHead().c_str(), stdout);
        for (const kerf::app::PaperExperiment& paper : kerf::app::paperExperiments()) {
            for (const bool cut : {false, true}) {
                kerf::test::play(paper, cut, options);
            }
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
