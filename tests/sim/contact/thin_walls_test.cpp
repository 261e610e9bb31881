// Bodies of thin walls keep their volume once cut, and their walls don't pass through each other.
// All scenes: kerf_contact_bench walls.
#include "tests/support/thin_walls.h"

#include <gtest/gtest.h>

#include <iostream>

#include "tests/support/gl_fixture.h"
#include "tests/support/nightly.h"

namespace kerf {
namespace {

using test::WallScene;

Params newScene() {
    Params params;
    params.iterations = kAutoIterations;
    return params;
}

class ThinWallsTest : public test::GlTest {};

/// Plays scenes, and says what went wrong in each.
void expectRight(const std::vector<WallScene>& scenes) {
    for (const WallScene& scene : scenes) {
        const test::WallFigures figures = test::playWalls(scene, newScene());
        std::cout << text(scene) << ": " << text(figures) << "\n";
        EXPECT_TRUE(figures.isRight()) << text(scene);
    }
}

// At rest a card of a 500th of its diagonal swelled by 9 %, fins of a 200th by 20 %.
TEST_F(ThinWallsTest, KeepTheirVolumeAtRest) {
    expectRight({{"plate", 1 / 200.0, "twice", "rests", 0.005, 0.1},
                 {"fins", 1 / 80.0, "twice", "rests", 0.005, 0.1},
                 {"cup", 1 / 200.0, "slanted", "rests", 0.005, 0.1}});
}

TEST_F(ThinWallsTest, KeepTheirVolumeWhereTheyFall) {
    expectRight({{"plate", 1 / 38.0, "twice", "falls", 0.005, 0.25},
                 {"cup", 1 / 38.0, "slanted", "falls", 0.005, 0.2},
                 {"cup", 1 / 200.0, "flush", "falls", 0.005, 0.2}});
}

TEST_F(ThinWallsTest, KeepTheirVolumeWhereTheyAreDrawn) {
    expectRight({{"fins", 1 / 500.0, "flush", "drawn", 0.005, 0.2},
                 {"shell", 1 / 500.0, "slanted", "drawn", 0.005, 0.2}});
}

TEST_F(ThinWallsTest, AllKeepTheirVolumeAtNight) {
    KERF_BY_NIGHT();
    expectRight(test::wallScenes(7));
}

}  // namespace
}  // namespace kerf
