#include <gtest/gtest.h>

#include <random>

#include "sim/body/ispc_set.h"

namespace kerf {
namespace {

TEST(SegmentGrid, FindsEverySegmentThatPassesABox) {
    const unsigned seed = 9;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto point = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
    Bounds box;
    box.add(Vec3(-1, -1, -1));
    box.add(Vec3(1, 1, 1));
    const int count = 3000;
    SegmentGrid grid(box, count);
    std::vector<std::pair<Vec3, Vec3>> segments;
    for (int id = 0; id < count; ++id) {
        segments.emplace_back(point(), point());
        if (id % 7 == 0) {  // along an axis, through corners of cells
            segments.back() = {Vec3(-1, 0, 0.5), Vec3(1, 0, 0.5)};
        }
        grid.add(id, segments.back().first, segments.back().second);
    }
    int passed = 0;
    for (int id = 0; id < count; ++id) {
        const auto& [from, to] = segments[id];
        Bounds around;
        around.add(from + (to - from) * (0.5 + 0.5 * uniform(random)));
        around.widen(1e-9);
        const std::vector<int> found = grid.find({&around, 1});
        EXPECT_TRUE(std::ranges::binary_search(found, id)) << id;
        passed += static_cast<int>(found.size());
    }
    EXPECT_LT(passed, count * count / 5) << "a cell holds few of them";
    EXPECT_FALSE(grid.overfull());
}

TEST(SegmentGrid, TellsWhenItHoldsMuchThatIsOld) {
    Bounds box;
    box.add(Vec3(0, 0, 0));
    box.add(Vec3(1, 1, 1));
    SegmentGrid grid(box, 500);
    int added = 0;
    while (!grid.overfull() && added < 100000) {
        grid.add(added++ % 500, Vec3(0, 0, 0), Vec3(1, 1, 1));
    }
    EXPECT_GT(added, 500);
    EXPECT_LT(added, 100000);
}

}  // namespace
}  // namespace kerf
