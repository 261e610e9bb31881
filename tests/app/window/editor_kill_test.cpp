// The editor is killed at random moments, or its graphics driver is reset, and what a next start
// offers to go on from lacks at most the running stroke. KERF_KILLS rounds, 1 by
// default; KERF_FUZZ_SEED repeats a run.

namespace kerf::app {
namespace {

int rounds() {
    return runs("KERF_KILLS", 1, 10);
}

/// The check of the state that the window had before the session was saved.
std::string hashOfWindow(const Session& session) {
    for (auto event = session.events.rbegin(); event != session.events.rend(); ++event) {
        if (const auto* check = std::get_if<CheckEvent>(&event->action)) {
            return check->hash.value_or("");
        }
    }
    return "";
}

class EditorKill : public GlTest, public testing::WithParamInterface<const char*> {};

TEST_P(EditorKill, AtMostTheRunningStrokeIsMissing) {
    if (GetParam() == std::string("reset")) {
        KERF_BY_NIGHT();  // EditorWindow has a reset of the driver, too
    }
    if (std::system(
            "command -v xvfb-run > /dev/null 2>&1 && command -v xdotool > /dev/null 2>&1") != 0) {
        GTEST_SKIP() << "needs xvfb-run and xdotool (Debian packages xvfb and xdotool)";
    }
    const test::TemporaryFolder folder;
    const std::uint32_t seed = fuzzSeed(std::random_device()() % 30000);
    const std::string seen =
        outputOf("xvfb-run -a -s '-screen 0 1280x720x24' bash " KERF_SOURCE_DIR
                 "/tests/app/window/editor_window_kill.sh " KERF_BINARY_DIR "/kerf " +
                 folder.path().string() + " " + std::to_string(rounds()) + " " +
                 std::to_string(seed % 32768) + " " + GetParam() + " 2>&1");
    std::printf("%s", seen.c_str());
    SCOPED_TRACE(readBytes(folder / "errors.txt"));
    EXPECT_THAT(seen, HasSubstr("end: reached"));
    EXPECT_THAT(seen, Not(HasSubstr("MISSING")));
    EXPECT_THAT(seen, Not(HasSubstr("left")));
    for (int n = 1; n <= rounds(); ++n) {
        SCOPED_TRACE(n);
        const Session session = readSession(folder / (std::to_string(n) + ".kerf.json"));
        EXPECT_EQ(replayedHash(session, loadSessionModel(session)), hashOfWindow(session));
    }
}

INSTANTIATE_TEST_SUITE_P(By, EditorKill, testing::Values("kill", "reset"),
                         [](const auto& end) { return std::string(end.param); });

}  // namespace
}  // namespace kerf::app
