// Models with colours and images of their own in the editor.
#include <gmock/gmock.h>

#include <regex>
#include <sstream>

#include "app/files/io/file_io.h"
#include "app/scene/editor_scene.h"
#include "app/scene/timeline/scene_recorder.h"
#include "app/session/session.h"
#include "tests/app/editor/editor_fixture.h"
#include "tests/support/written_png.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;

/// A ball that an image makes green.
class EditorLooksTest : public EditorTest {
  protected:
    void writeGreenBall() {
        std::vector<std::uint8_t> pixels;
        for (int i = 0; i < 16; ++i) {
            pixels.insert(pixels.end(), {20, 220, 40, 255});
        }
        test::writePng({4, 4, pixels}, folder / "green.png");
        std::string text = "mtllib ball.mtl\nusemtl paint\nvt 0.5 0.5\n";
        std::istringstream lines(test::objText(test::cubeSphereSoup(8, 0.5)));
        for (std::string line; std::getline(lines, line);) {
            text +=
                line[0] == 'f' ? std::regex_replace(line, std::regex("( [0-9]+)"), "$1/1") : line;
            text += "\n";
        }
        test::writeText(folder / "ball.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd green.png\n");
        test::writeText(folder / "ball.obj", text);
    }
    /// High enough for all sections.
    void startWithRoom() {
        EditorOptions options = plainOptions();
        options.height = 1600;
        start(options);
    }
    void open(const std::string& name) {
        editor->open(folder / name);
        waitForWork();
        moveTo(5, 5);
        settle();
    }
    /// What the middle of the view shows.
    std::array<int, 3> middle() {
        settle();
        const render::Image picture = editor->readPicture();
        const std::size_t at =
            4 * (std::size_t(picture.height / 2) * picture.width + picture.width / 2);
        return {picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]};
    }
    static bool isGreen(const std::array<int, 3>& color) {
        return color[1] > 2 * color[0] && color[1] > 2 * color[2];
    }
};

TEST_F(EditorLooksTest, AnImageIsShownFollowsACutAndItsUndo) {
    writeGreenBall();
    open("ball.obj");
    EXPECT_TRUE(isGreen(middle()));
    const std::vector<std::uint8_t> before = viewPixels(editor->readPicture());
    drag(kTop, kBottom, 10);
    settle();
    moveTo(5, 5);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
    tap(Key::t);  // no dark line along the cut
    EXPECT_TRUE(isGreen(middle()));
    tap(Key::t);
    tap(Key::z, {.control = true});
    moveTo(5, 5);
    settle();
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_TRUE(isGreen(middle()));
}

TEST_F(EditorLooksTest, TheLookIsShownInsteadOnDemandAndInTheSession) {
    startWithRoom();
    writeGreenBall();
    open("ball.obj");
    ASSERT_TRUE(panels().looks.hasOwnColors);
    ASSERT_TRUE(isGreen(middle()));
    click("section.display");
    click("color.own");
    EXPECT_FALSE(isGreen(middle()));
    const SavedSession saved =
        editor->scene()->recorder().savedSession(render::Camera{}, panels().display.colors);
    EXPECT_TRUE(saved.session.colors.ofLook);
}

TEST_F(EditorLooksTest, AMissingImageIsToldOf) {
    writeGreenBall();
    std::filesystem::remove(folder / "green.png");
    open("ball.obj");
    EXPECT_THAT(panels().toast.text,
                HasSubstr("The image \"green.png\" of the material \"paint\""));
    EXPECT_FALSE(isGreen(middle()));
}

}  // namespace
}  // namespace kerf::app
