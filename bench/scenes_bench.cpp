// Bodies cut while they move, eight strokes for each scene and Young's modulus: one row each.
//   kerf_scenes_bench [--scene NAME] [--modulus PA] [--index I] [--runs N] [--seed S] [--more]
//     [--contact 0] [--push 1] [--grading RATIO] [--after STEPS]
// --more adds those beyond the six. Folds are counted 50 steps (soon) and STEPS, 300, after the
// last stroke; "mean" is that of folds over the last 100 steps, all strokes of the row together.
// --index plays that stroke alone and prints its steps, and the folded edges every 50 steps after
// it.

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "gpu/context.h"
#include "tests/support/moving_scenes.h"

namespace kerf::test {
namespace {

constexpr int kStepsAfter = 300;  // until most of what rolls or swings is quiet

using Options = std::map<std::string, std::string>;

Options readOptions(int count, char** words) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        options[word] = word != "--more" && i + 1 < count ? words[++i] : "";
    }
    return options;
}

double number(const Options& options, const std::string& name, double otherwise) {
    const auto at = options.find(name);
    return at == options.end() ? otherwise : std::atof(at->second.c_str());
}

void play(const Options& options, SceneRun run) {
    run.contact = number(options, "--contact", 1) != 0;
    run.push = number(options, "--push", 0) != 0;
    run.grading = number(options, "--grading", 1);
    run.stepsAfter = static_cast<int>(number(options, "--after", kStepsAfter));
    run.seed = static_cast<std::uint64_t>(number(options, "--seed", 1));
    if (options.count("--index") > 0) {
        run.index = static_cast<int>(number(options, "--index", 0));
        run.verbose = true;
        const SceneFigures figures = playScene(run);
        std::fputs(sceneTableRow(run, figures).c_str(), stdout);
        return;
    }
    SceneFigures sum;
    for (run.index = 0; run.index < static_cast<int>(number(options, "--runs", 8)); ++run.index) {
        const SceneFigures figures = playScene(run);
        if (figures.refused + figures.unseparated + figures.slitEdges + figures.nonFinite > 0) {
            std::printf("  index %d: %s", run.index, sceneTableRow(run, figures).c_str());
        }
        sum.add(figures);
    }
    std::fputs(sceneTableRow(run, sum).c_str(), stdout);
    std::fflush(stdout);
}

void playAll(const Options& options) {
    const auto only = options.find("--scene");
    std::printf("seed %.0f\n%s", number(options, "--seed", 1), sceneTableHead().c_str());
    for (const auto* list : {&movingScenes(), &furtherScenes()}) {
        if (list == &furtherScenes() && only == options.end() && options.count("--more") == 0) {
            continue;
        }
        for (const std::string& scene : *list) {
            for (const double modulus : {1e5, 3e5}) {
                if ((only == options.end() || scene.find(only->second) != std::string::npos) &&
                    number(options, "--modulus", modulus) == modulus) {
                    play(options, {scene, modulus});
                }
            }
        }
    }
}

}  // namespace
}  // namespace kerf::test

int main(int count, char** words) {
    try {
        const kerf::gpu::EglContext context;
        kerf::test::playAll(kerf::test::readOptions(count, words));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
