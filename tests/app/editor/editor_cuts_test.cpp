// The quality of cuts in the panel.
#include "app/scene/readout/cut_quality.h"
#include "tests/app/editor/editor_fixture.h"

namespace kerf::app {
namespace {

class EditorCuts : public EditorTest {
  protected:
    /// Frames until the figures are there.
    void waitForFigures() {
        settle();
        for (int i = 0; i < 2000 && panels().cuts.note.starts_with("Measuring"); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frames(1);
        }
    }
    void cutAcross() {
        drag(kTop, kBottom, 10);
        waitForFigures();
    }
    /// Folds others first, so that there is room.
    void openSection() {
        for (const char* section : {"section.simulation", "section.tools", "section.cuts"}) {
            click(section);
        }
    }
    std::string figure(const std::string& quantity) {
        for (const ui::CutRow& row : panels().cuts.rows) {
            if (row.quantity == quantity) {
                return row.all;
            }
        }
        return "none";
    }
};

TEST_F(EditorCuts, AreMeasuredWhereTheirSectionIsOpen) {
    cutAcross();
    ASSERT_GT(panels().body.triangles, 768) << "it was cut";
    EXPECT_TRUE(panels().cuts.rows.empty()) << "the section is folded";
    openSection();
    waitForFigures();
    EXPECT_EQ(figure("Self-intersections"), "0");
    EXPECT_GT(std::stoi(figure("Triangles")), 100);
    EXPECT_GT(std::stoi(figure("Cutting steps")), 3);
    EXPECT_EQ(panels().cuts.note, "");
    EXPECT_TRUE(editor->itemRects().contains("cuts.Triangles"));
}

TEST_F(EditorCuts, FollowUndo) {
    openSection();
    EXPECT_EQ(panels().cuts.note, "No cuts yet.");
    cutAcross();
    const std::string made = figure("Triangles");
    EXPECT_GT(std::stoi(made), 100);
    tap(Key::z, {.control = true});
    waitForFigures();
    EXPECT_EQ(figure("Triangles"), "none");
    EXPECT_EQ(panels().cuts.note, "No cuts yet.");
    tap(Key::z, {.shift = true, .control = true});
    waitForFigures();
    EXPECT_EQ(figure("Triangles"), made);
}

}  // namespace
}  // namespace kerf::app
