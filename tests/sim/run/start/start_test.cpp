// The memory that a body is said to need, against what it takes.
#include <malloc.h>

#include "gpu/program.h"
#include "sim/run/start/memory_need.h"
#include "tests/support/buffer_bytes.h"

namespace kerf {
namespace {

constexpr double kWithin = 1.5;  // the need is at most so many times what is taken

BodySize sizeOf(const SurfaceMesh& mesh) {
    return {static_cast<double>(mesh.vertexCount()), static_cast<double>(mesh.triangleSlots())};
}

std::vector<SurfaceMesh> bodies() {
    std::vector<SurfaceMesh> all;
    for (const int quads : {40, 64}) {
        all.push_back(cubeSphere(quads, 0.5));
    }
    return all;
}

TEST(MemoryNeed, GrowsWithTheBodyAndWithWhatIsAskedOfIt) {
    const auto small = memoryNeedOf(BodySize::ofTriangles(1e4), {});
    const auto large = memoryNeedOf(BodySize::ofTriangles(1e5), {});
    EXPECT_GT(large.memory, 9 * small.memory);
    EXPECT_GT(large.graphics, 9 * small.graphics);
    EXPECT_EQ(large.program, small.program);
    EXPECT_GT(small.graphics,
              memoryNeedOf(BodySize::ofTriangles(1e4), {.contact = false}).graphics);
    EXPECT_LT(small.graphics,
              memoryNeedOf(BodySize::ofTriangles(1e4), {.obstacles = true}).graphics);
    const auto undoable = memoryNeedOf(BodySize::ofTriangles(1e4), {.undoBudget = 1'000'000'000});
    EXPECT_GT(undoable.memory, small.memory);
    const auto tooLarge = memoryNeedOf(BodySize::ofTriangles(1e4), {.undoBudget = 1'000'000});
    EXPECT_EQ(tooLarge.memory, small.memory) << "what is beyond the budget is not kept";
}

TEST(MemoryNeed, IsAboutWhatACopyTakes) {
    const auto inUse = [] { return ::mallinfo2().uordblks + ::mallinfo2().hblkhd; };
    if (inUse() == 0) {
        GTEST_SKIP() << "this heap does not count";
    }
    for (SurfaceMesh& mesh : bodies()) {
        const BodySize size = sizeOf(mesh);
        const PreparedBody body(std::move(mesh));
        const std::size_t before = inUse();
        const SurfaceMesh copyOfMesh = std::as_const(body.uncut->mesh);
        const std::size_t used = (inUse() - before) / 2;  // as much again is reserved
        const BodyUpdater copyOfBody = *body.body;
        const Cutter copyOfCutter = *body.cutter;
        const double taken = static_cast<double>(inUse() - before - used);
        const auto counted = static_cast<double>(bytesOfSnapshot(size));
        std::printf("%.0f triangles: %.0f bytes by heap, %.0f by records\n", size.triangles, taken,
                    counted);
        EXPECT_GE(counted, taken);
        EXPECT_LE(counted, kWithin * taken);
        EXPECT_GE(bytesPrepared(size), 2 * bytesOfSnapshot(size));
    }
}

class MemoryNeedOnGpu : public GlTest {};

TEST_F(MemoryNeedOnGpu, IsAboutWhatTheDriverIsAskedFor) {
    for (SurfaceMesh& mesh : bodies()) {
        const BodySize size = sizeOf(mesh);
        const BufferBytes buffers;
        Simulation simulation(std::move(mesh), plainPbd());
        simulation.step();
        const auto taken = static_cast<double>(buffers.now());
        const auto need = static_cast<double>(bytesOnGpu(size, memorySettings(plainPbd(), false)));
        std::printf("%.0f triangles: %.0f bytes of buffers, %.0f by records\n", size.triangles,
                    taken, need);
        EXPECT_GE(need, taken);
        EXPECT_LE(need, kWithin * taken);
        // Of a body that was cut.
        const auto largest = memoryNeedOf(size, memorySettings(plainPbd(), false)).largestBuffer;
        EXPECT_NEAR(static_cast<double>(largest) / static_cast<double>(buffers.largest()), 1.75,
                    0.1);
    }
}

// Of sizes with small aggregates and large ones. Rays that are cast anew have room to grow, so the
// driver is asked for a little more than records take.
TEST_F(MemoryNeedOnGpu, IsAboutWhatImplicitStepsAskFor) {
    const MemorySettings settings = memorySettings(Params{}, false);
    for (const int quads : {16, 24, 40}) {
        SurfaceMesh mesh = cubeSphere(quads, 0.5);
        const BodySize size = sizeOf(mesh);
        const BufferBytes buffers;
        Simulation simulation(std::move(mesh), Params{});
        simulation.step();
        const auto taken = static_cast<double>(buffers.now());
        const auto need = static_cast<double>(bytesOnGpu(size, settings));
        std::printf("%.0f triangles: %.0f bytes of buffers, %.0f by records\n", size.triangles,
                    taken, need);
        EXPECT_GE(need, 0.9 * taken);
        EXPECT_LE(need, kWithin * taken);
        const MemoryNeed all = memoryNeedOf(size, settings);
        EXPECT_GE(all.graphics, buffers.now());
        EXPECT_NEAR(double(all.largestBuffer) / double(buffers.largest()), 1.75, 0.1);
    }
}

}  // namespace
}  // namespace kerf
