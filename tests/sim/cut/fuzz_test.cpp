namespace kerf {
namespace {

constexpr std::uint64_t kFirstSeed = 1000;
constexpr int kRuns = 150;
constexpr int kRunsByNight = 1500;
// Slivers that one spot may keep where several cuts meet within a thousandth of an edge.
constexpr int kCrowd = 12;

// KERF_FUZZ_SECONDS runs longer, KERF_FUZZ_SEED elsewhere (KERF_FUZZ_RUNS=1 repeats one seed),
// KERF_FUZZ_TRACE tells what each step did;
// KERF_FUZZ_NO_CLEANUP shows what the cut alone leaves, and fails on it; KERF_FUZZ_EVEN_WALLS gives
// walls the mean edge length everywhere; KERF_FUZZ_MODE=rocking or another draws strokes of one
// kind.
FuzzReport runFuzz() {
    using Clock = std::chrono::steady_clock;
    const auto first = static_cast<std::uint64_t>(environmentNumber("KERF_FUZZ_SEED", kFirstSeed));
    const double seconds = environmentNumber("KERF_FUZZ_SECONDS", 0);
    const int runs = test::runs("KERF_FUZZ_RUNS", kRuns, kRunsByNight);
    const auto elapsed = [start = Clock::now()] {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    FuzzReport report;
    for (int i = 0; seconds > 0 ? elapsed() < seconds : i < runs; ++i) {
        fuzzOnce(first + static_cast<std::uint64_t>(i), report);
    }
    std::cout << "first seed " << first << "\n" << report.table();
    return report;
}

TEST(CutFuzz, MeshesStayClosedAndStepsSucceed) {
    const FuzzReport report = runFuzz();
    for (const FuzzSetting setting : kFuzzSettings) {
        const FuzzFigures sum = report.total(setting);
        EXPECT_EQ(sum.invalid, 0);
        EXPECT_LE(sum.refused, (setting == FuzzSetting::rounded ? 0.001 : 0.0) * sum.cuts)
            << "of " << sum.cuts << " steps";
        EXPECT_EQ(sum.outside, 0) << "of " << sum.strokes << " strokes";
        EXPECT_EQ(sum.unseparated, 0) << "of " << sum.strokes << " strokes";
        EXPECT_LE(sum.mostVolumeChange, 1e-6);
        const SliverCount slivers = report.ordinary(setting).quality.all();
        EXPECT_LE(slivers.below002, 0.005 * slivers.triangles) << "of " << slivers.triangles;
        // They come in crowds: two crowds in a short run say nothing about thousands of strokes.
        EXPECT_LE(slivers.below0001, 1e-4 * slivers.triangles + 2 * kCrowd)
            << "of " << slivers.triangles;
        const FuzzFigures ordinary = report.ordinary(setting);
        EXPECT_LE(ordinary.intersecting, 0.02 * ordinary.strokes + 1);
        EXPECT_EQ(sum.unmirrored, 0) << "of " << sum.strokes << " strokes";
    }
}

// Strokes that once went wrong.
TEST(CutFuzz, KnownStrokesLeaveSoundMeshes) {
    struct Row {
        const char* what;
        FuzzSetting setting;
        std::vector<std::uint64_t> seeds;
    };
    for (const auto& [what, setting, seeds] : std::vector<Row>{
             {"the clean-up cut the skin short over the wall",
              FuzzSetting::exact,
              {400112, 400023}},
             {"chords of curved walls passed through the skin",
              FuzzSetting::exact,
              {402046, 405643}},
             {"chords of walls across a kink lay in the skin or in older walls",
              FuzzSetting::exact,
              {400777, 401948, 402995, 403455, 404144, 404528, 405566, 406024, 406257}},
             {"three nodes of curves at one place on a wall that is cut again",
              FuzzSetting::exact,
              {70350}},
             {"edges flipped on both sides of walls, which noise had moved apart",
              FuzzSetting::rounded,
              {400514, 401847}}}) {
        for (const std::uint64_t seed : seeds) {
            SCOPED_TRACE(what + (", seed " + std::to_string(seed)));
            FuzzReport report;
            fuzzOnce(seed, report);
            const FuzzFigures figures = report.total(setting);
            EXPECT_GT(figures.strokes, 0);
            EXPECT_EQ(figures.intersecting, 0);
            EXPECT_EQ(figures.unmirrored, 0);
            EXPECT_EQ(figures.invalid, 0);
        }
    }
}

// The blade passes an edge of an older wall within the noise of its two sides, or between the ways
// in which they are seen open: one side was divided there and the other at the vertex beside it.
TEST(CutFuzz, BothSidesOfOlderWallsAreDividedAlike) {
    for (const std::uint64_t seed : {401844, 403183, 405875, 406492, 406716, 407148}) {
        FuzzReport report;
        fuzzOnce(seed, report);
        int strokes = 0;
        for (const FuzzSetting setting : kFuzzSettings) {
            const FuzzFigures figures = report.total(setting);
            strokes += figures.strokes;
            EXPECT_EQ(figures.unmirrored, 0) << "seed " << seed;
            EXPECT_EQ(figures.refused, 0) << "seed " << seed;
            EXPECT_EQ(figures.invalid, 0) << "seed " << seed;
        }
        EXPECT_GT(strokes, 1) << "seed " << seed;
    }
}

}  // namespace
}  // namespace kerf
