// The editor in a real window under a virtual display, driven by synthetic mouse and keys.
#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "app/model_source.h"
#include "render/image.h"
#include "tests/support/run_kerf.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

bool hasCommand(const std::string& name) {
    return std::system(("command -v " + name + " > /dev/null 2>&1").c_str()) == 0;
}

std::string outputOf(const std::string& command) {
    std::string text;
    FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) {
        return text;
    }
    char chunk[256];
    while (std::fgets(chunk, sizeof chunk, pipe) != nullptr) {
        text += chunk;
    }
    ::pclose(pipe);
    return text;
}

/// "name: value" lines.
std::map<std::string, std::string> valuesIn(const std::string& text) {
    std::map<std::string, std::string> values;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::size_t colon = text.find(": ", begin);
        if (colon < end) {
            values[text.substr(begin, colon - begin)] = text.substr(colon + 2, end - colon - 2);
        }
        begin = end + 1;
    }
    return values;
}

TEST(EditorWindow, ADragThroughTheMiddleCutsTheDropInInTwo) {
    if (!hasCommand("xvfb-run") || !hasCommand("xdotool")) {
        GTEST_SKIP() << "needs xvfb-run and xdotool (Debian packages xvfb and xdotool)";
    }
    const test::TemporaryFolder folder;
    const std::string seen = outputOf("xvfb-run -a -s '-screen 0 1280x720x24' bash " KERF_SOURCE_DIR
                                      "/tests/app/editor_window.sh " KERF_BINARY_DIR "/kerf " +
                                      folder.path().string() + " 2>&1");
    SCOPED_TRACE(seen + test::readBytes(folder / "errors.txt"));
    std::map<std::string, std::string> values = valuesIn(seen);
    EXPECT_EQ(values["opened"], "Kerf - drop-in - 1 piece");
    EXPECT_EQ(values["cut"], "Kerf - drop-in - 2 pieces");
    EXPECT_EQ(values["exit"], "0");
    ASSERT_THAT(values["screenshot"], ::testing::MatchesRegex("kerf-[0-9]{8}-[0-9]{6}\\.png"));
    const render::Image picture = render::readPng(folder / values["screenshot"]);
    EXPECT_EQ(picture.width, 1280);
    EXPECT_EQ(picture.height, 720);
}

TEST(EditorWindow, AModelIsOpenedByTheDialogExportedAndALoadingCancelled) {
    if (!hasCommand("xvfb-run") || !hasCommand("xdotool")) {
        GTEST_SKIP() << "needs xvfb-run and xdotool (Debian packages xvfb and xdotool)";
    }
    const test::TemporaryFolder folder;
    test::writeText(folder / "ball.obj", test::objText(test::icosphereSoup(2)));
    test::writeText(folder / "slow.obj", test::objText(test::icosphereSoup(1)));
    const std::string seen =
        outputOf("xvfb-run -a -s '-screen 0 1280x720x24' bash " KERF_SOURCE_DIR
                 "/tests/app/editor_window_files.sh " KERF_BINARY_DIR "/kerf " +
                 folder.path().string() + " 2>&1");
    SCOPED_TRACE(seen + test::readBytes(folder / "errors.txt"));
    std::map<std::string, std::string> values = valuesIn(seen);
    EXPECT_EQ(values["opened"], "Kerf - ball - 1 piece");
    EXPECT_EQ(values["exported"], "whole.obj");
    EXPECT_EQ(values["loading"], "Kerf - ball - 1 piece") << "what is open stays";
    EXPECT_EQ(values["cancelled"], "Kerf - ball - 1 piece");
    EXPECT_EQ(values["exit"], "0");
    MeshReport report;
    loadModel(folder / "whole.obj", &report);
    EXPECT_EQ(report.triangles, 320);
}

TEST(EditorWindow, WithoutADisplayItSaysSoAndExits4) {
    const test::ProgramRun run = test::runKerf({}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
    EXPECT_EQ(run.exitCode, 4);
    EXPECT_THAT(run.errors, ::testing::HasSubstr("No window can be opened"));
    EXPECT_EQ(run.out, "");
}

TEST(EditorWindow, WithoutOpenGlItExits4) {
    EXPECT_EQ(test::runKerf({}, {{"KERF_FORCE_NO_GL", "1"}}).exitCode, 4);
}

TEST(EditorWindow, AFileThatIsMissingIsExitCode3) {
    const test::ProgramRun run = test::runKerf({"no-such-model.obj"});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_THAT(run.errors, ::testing::HasSubstr("no-such-model.obj"));
}

}  // namespace
}  // namespace kerf::app
