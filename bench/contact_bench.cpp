// What contact must hold: halves that rest on each other, an octopus dropped on
// its arms, bodies dropped and thrown at random, spheres that fall onto bars.
//   kerf_contact_bench [halves|blocks|octopus|speed|crowd|poured|dropped_halves|collision|
//   drops|bars|walls] [--runs N] [--first I] [--seed S] [--size TRIANGLES] [--every N]
//   [--seconds S] [--NAME VALUE ...]
// where NAME is a parameter of the simulation.

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "gpu/context.h"
#include "tests/support/bar_falls.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/thin_walls.h"

namespace kerf::test {
namespace {

struct Options {
    std::string scene;
    int runs = 10;
    int first = 0;
    std::uint64_t seed = 1;
    int size = 20'000;  ///< of `dropped_halves` [triangles]
    int every = 1;      ///< of the scenes of `walls`, only each so many-th
    double seconds = 1;
    Params params;
};

/// A number, or the name of a choice.
ParamValue valueOf(const char* given) {
    char* end = nullptr;
    const double number = std::strtod(given, &end);
    return *end == '\0' ? ParamValue(number) : ParamValue(std::string(given));
}

Options readOptions(int count, char** words) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (!word.starts_with("--")) {
            options.scene = word;
        } else if (i + 1 < count) {
            const char* given = words[++i];
            const double value = std::atof(given);
            if (word == "--runs") {
                options.runs = static_cast<int>(value);
            } else if (word == "--first") {
                options.first = static_cast<int>(value);
            } else if (word == "--size") {
                options.size = static_cast<int>(value);
            } else if (word == "--every") {
                options.every = static_cast<int>(value);
            } else if (word == "--seconds") {
                options.seconds = value;
            } else if (word == "--seed") {
                options.seed = static_cast<std::uint64_t>(value);
            } else if (const std::string error =
                           setParam(options.params, word.substr(2), valueOf(given));
                       !error.empty()) {
                throw std::invalid_argument(error);
            }
        }
    }
    return options;
}

void playDrops(const Options& options) {
    RandomDropFigures sum;
    for (int i = options.first; i < options.first + options.runs; ++i) {
        const RandomDropFigures figures = dropAtRandom({options.seed, i}, options.params);
        if (figures.nonFinite + figures.escaped + figures.tunnels + figures.intersections +
                figures.crumpled >
            0) {
            std::printf("  drop %d: %s\n", i, text(figures).c_str());
            std::fflush(stdout);
        }
        sum.add(figures);
    }
    std::printf("drops from seed %llu: %s\n", static_cast<unsigned long long>(options.seed),
                text(sum).c_str());
}

/// Of the neighbourhood of thin walls: `--first I --runs N`, each `--every`-th one.
void playThinWalls(const Options& options) {
    const std::vector<WallScene> scenes = wallScenes(options.every);
    const int end = std::min(options.first + options.runs, static_cast<int>(scenes.size()));
    int wrong = 0;
    int runs = 0;
    for (int i = options.first; i < end; ++i) {
        const WallFigures figures = playWalls(scenes[i], options.params);
        std::printf("%d: %s: %s\n", i, text(scenes[i]).c_str(), text(figures).c_str());
        std::fflush(stdout);
        wrong += figures.isRight() ? 0 : 1;
        ++runs;
    }
    std::printf("%d of %d wrong\n", wrong, runs);
}

/// How high spheres fall, how the bar lies: by `--seed`, 1 to 5.
BarFall kindOfFall(std::uint64_t seed) {
    BarFall fall;
    if (seed == 2) {
        fall.height = 2;
        fall.roll = 30;
        fall.aside = 0.1;
    } else if (seed == 3) {
        fall.height = 0.5;
        fall.roll = 45;
        fall.aside = 0.001;
    } else if (seed == 4) {
        fall.height = 2;
        fall.aside = 0.001;
    } else if (seed == 5) {
        fall.floor = -0.3;
    }
    return fall;
}

/// 42 falls, or some of them: `--first I --runs N`.
void playBarFalls(const Options& options) {
    const BarFall kind = kindOfFall(options.seed);
    int index = 0;
    int pierced = 0;
    int last = 0;
    for (const char* model : {"sphere80", "sphere768"}) {
        for (const double modulus : {1e4, 3e4, 1e5}) {
            for (const double width : {0.005, 0.01, 0.02, 0.05, 0.1, 0.3, 1.0}) {
                if (index++ < options.first || index > options.first + options.runs) {
                    continue;
                }
                BarFall fall = kind;
                fall.model = model;
                fall.modulus = modulus;
                fall.width = width;
                const BarFigures figures = fallOnBar(fall, options.params);
                pierced += figures.pierced > 0;
                last += figures.longestLast > 0;
                std::printf("  bar %2d: %-9s %6.0f Pa %5.3f m: %s\n", index - 1, model, modulus,
                            width, text(figures).c_str());
                std::fflush(stdout);
            }
        }
    }
    std::printf("bars: pierced %d, at the end %d\n", pierced, last);
}

void play(const Options& options) {
    const auto asked = [&](const char* name) {
        return options.scene.empty() || options.scene == name;
    };
    if (asked("halves")) {
        std::printf("halves: %s\n", text(restHalves(true, options.params)).c_str());
        std::fflush(stdout);
    }
    if (asked("blocks")) {
        std::printf("blocks: %s\n", text(restHalves(false, options.params)).c_str());
        std::fflush(stdout);
    }
    if (asked("octopus")) {
        std::printf("octopus: %s\n", text(dropOctopus(options.params)).c_str());
        std::fflush(stdout);
    }
    if (asked("speed")) {
        for (const char* model : {"sphere768", "banana", "octopus"}) {
            std::printf("%s: %s\n", model, text(timeDrop(model, options.params)).c_str());
            std::fflush(stdout);
        }
    }
    if (asked("crowd")) {
        for (const double speed : {1.0, 5.0, 20.0}) {
            std::printf("crowd at %.0f m/s: %s\n", speed,
                        text(throwCrowd(speed, options.params)).c_str());
            std::fflush(stdout);
        }
    }
    if (asked("poured")) {
        std::printf("poured: %s\n", text(pourBalls(options.params, options.seconds)).c_str());
        std::fflush(stdout);
    }
    if (asked("dropped_halves")) {
        const CostFigures figures = dropHalves(options.size, options.params, options.seconds);
        std::printf("dropped halves: %s\n", text(figures).c_str());
        std::fflush(stdout);
    }
    if (asked("collision")) {
        std::printf("collision: %s\n", text(collideSpheres(options.params)).c_str());
        std::fflush(stdout);
    }
    if (asked("bars")) {
        playBarFalls(options);
    }
    if (options.scene == "walls") {
        playThinWalls(options);
    }
    if (asked("drops")) {
        playDrops(options);
    }
}

}  // namespace
}  // namespace kerf::test

int main(int count, char** words) {
    try {
        const kerf::test::Options options = kerf::test::readOptions(count, words);
        const kerf::gpu::EglContext context;
        kerf::test::play(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
