// A driver that Kerf meets for the first time is examined behind the window.
#include "app/editor/storage/driver_check.h"

#include "tests/app/editor/editor_fixture.h"
#include "tests/support/variable.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class DriverCheckTest : public EditorTest {
  protected:
    /// Instead of kerf: notes that it ran, at low priority, and leaves a report with that end.
    void examinationEnds(const std::string& command, const std::string& verdict) {
        const fs::path program = folder / "examiner.sh";
        const std::string report =
            verdict.empty() ? ""
                            : "echo '{\"verdict\": \"" + verdict + "\"}' > \"$4/doctor.json\"\n";
        test::writeText(program, "#!/bin/sh\n[ $(nice) -ge 5 ] && echo \"$@\" >> " +
                                     (folder / "ran").string() + "\n" + report + command + "\n");
        fs::permissions(program, fs::perms::owner_all);
    }
    EditorOptions examining(const std::string& driver) {
        EditorOptions options = EditorTest::options();
        options.settingsFile = folder / "settings.json";
        options.driverReports = folder / "drivers";
        options.driver = driver;
        return options;
    }
    /// Starts an editor on a driver and waits until it has been examined.
    void meet(const std::string& driver) {
        const test::Variable program("KERF_EXECUTABLE", (folder / "examiner.sh").string());
        start(examining(driver));
        for (int i = 0; i < 2000 && editor->idleSeconds() < 1; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frames(1);
        }
        frames(2);
    }
    std::size_t examinations() const {
        const std::string ran = test::readBytes(folder / "ran");
        return static_cast<std::size_t>(std::ranges::count(ran, '\n'));
    }
};

TEST_F(DriverCheckTest, ADriverThatIsRightIsExaminedOnceAndNothingIsSaid) {
    examinationEnds("exit 0", "All is well.");
    meet("Maker's renderer (4.6) 1.2");
    meet("Maker's renderer (4.6) 1.2");
    EXPECT_EQ(examinations(), 1u);
    EXPECT_THAT(test::readBytes(folder / "ran"), HasSubstr("doctor --quick --out "));
    EXPECT_THAT(panels().question.text, IsEmpty());
    meet("Maker's renderer (4.6) 1.3");
    EXPECT_EQ(examinations(), 2u) << "a newer driver is another one";
}

TEST_F(DriverCheckTest, OfAWrongDriverThePersonIsToldAndOfferedTheSoftwareRenderer) {
    examinationEnds("exit 1", "Free fall is wrong.");
    meet("Maker's renderer");
    EXPECT_THAT(panels().question.text, HasSubstr("Free fall is wrong. The report is in"));
    ASSERT_EQ(panels().question.choices.size(), 2u);
    tap(Key::enter);
    frames(2);
    EXPECT_THAT(panels().toast.text, HasSubstr("Restart Kerf"));
    EXPECT_THAT(test::readBytes(folder / "settings.json"),
                HasSubstr("\"software_renderer\": true"));
    meet("Maker's renderer");
    EXPECT_EQ(examinations(), 1u);
    EXPECT_THAT(panels().question.text, IsEmpty()) << "it is asked once";
}

TEST_F(DriverCheckTest, WhoGoesOnWithTheDriverKeepsIt) {
    examinationEnds("exit 1", "Free fall is wrong.");
    meet("Maker's renderer");
    tap(Key::escape);
    frames(2);
    EXPECT_THAT(panels().question.text, IsEmpty());
    EXPECT_FALSE(panels().settings.softwareRenderer);
}

TEST_F(DriverCheckTest, AnExaminationThatCrashesIsTold) {
    examinationEnds("kill -SEGV $$", "");
    meet("Maker's renderer");
    EXPECT_THAT(panels().question.text, HasSubstr("did not finish (it was ended by signal 11)"));
    tap(Key::escape);
    meet("Maker's renderer");
    EXPECT_EQ(examinations(), 2u) << "it may have been the machine";
}

TEST(DriverReports, TheVariableLeavesDriversAlone) {
    const test::Variable state("XDG_STATE_HOME", "/state");
    EXPECT_EQ(defaultDriverReports(), "/state/kerf/drivers");
    const test::Variable off("KERF_EXAMINES_DRIVER", "no");
    EXPECT_EQ(defaultDriverReports(), "");
}

}  // namespace
}  // namespace kerf::app
