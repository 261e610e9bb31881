// What `cmake --install` puts into a folder works from there, with its own shaders and assets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/paths.h"
#include "tests/support/program_output.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using test::outputOf;
using test::readBytes;
using test::writeText;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class Installed : public testing::Test {
  protected:
    Installed() {
        said_ = outputOf("cmake --install '" KERF_BINARY_DIR "' --prefix '" + prefix() + "' 2>&1");
    }
    std::string prefix() const { return folder_ / "moved"; }
    std::string run(const std::string& arguments) const {
        return outputOf("cd '" + folder_.path().string() + "' && '" + prefix() + "/bin/kerf' " +
                        arguments + " 2>&1");
    }

    test::TemporaryFolder folder_;
    std::string said_;
};

TEST_F(Installed, TheProgramReadsWhatWasInstalledWithIt) {
    ASSERT_THAT(said_, Not(HasSubstr("failed")));
    const std::string replay =
        "replay moved/share/kerf/assets/sessions/sphere20.kerf.json --until 12 --out out";
    EXPECT_THAT(run(replay), HasSubstr("sphere20: 12 steps"));

    // What the source tree has is as it was: only the copies that lie there are changed.
    fs::copy_file(prefix() + "/share/kerf/assets/materials/gelatin.json",
                  prefix() + "/share/kerf/assets/materials/unobtainium.json");
    EXPECT_THAT(run("materials"), HasSubstr("unobtainium"));
    for (const auto& shader : fs::recursive_directory_iterator(prefix() + "/share/kerf/shaders")) {
        if (shader.path().extension() == ".comp") {
            writeText(shader.path(), "no shader");
        }
    }
    EXPECT_THAT(run(replay), HasSubstr("syntax error"));
}

TEST_F(Installed, ThePagesKnowAllVerbs) {
    const std::string page = outputOf("zcat '" + prefix() + "/share/man/man1/kerf.1.gz'");
    const std::string completion = readBytes(prefix() + "/share/bash-completion/completions/kerf");
    for (const char* const verb : {"replay", "experiment", "inspect", "compare", "test",
                                   "materials", "schema", "sweep", "doctor"}) {
        EXPECT_THAT(completion, HasSubstr(std::string(verb) + ") words='"));
        EXPECT_THAT(page, HasSubstr(std::string("kerf ") + verb + " "));
    }
    EXPECT_THAT(page, HasSubstr("\\-\\-movie FILE\n"));
    EXPECT_THAT(page, Not(HasSubstr("TEXT")));
    const auto completed = [&](const std::string& words, int at) {
        return outputOf("bash -c \"source '" + prefix() +
                        "/share/bash-completion/completions/kerf'; COMP_WORDS=(" + words +
                        "); COMP_CWORD=" + std::to_string(at) +
                        "; _kerf; echo \\${COMPREPLY[*]}\"");
    };
    EXPECT_EQ(completed("kerf ex", 1), "experiment\n");
    EXPECT_EQ(completed("kerf replay --mo", 2), "--movie\n");
    EXPECT_EQ(completed("kerf replay --meshes v", 3), "vtp\n");
    EXPECT_EQ(completed("kerf materials gel", 2), "gelatin\n");
    EXPECT_EQ(completed("kerf inspect --out", 2), "\n") << "that is no option of it";
}

TEST_F(Installed, TheDesktopFindsAllItsParts) {
    for (const char* const part :
         {"share/applications/kerf.desktop", "share/mime/packages/kerf.xml",
          "share/metainfo/kerf.metainfo.xml", "share/icons/hicolor/scalable/apps/kerf.svg",
          "share/doc/kerf/copyright", "share/kerf/assets/models/banana.obj",
          "share/kerf/assets/environments/studio-dark.hdr"}) {
        EXPECT_TRUE(fs::exists(fs::path(prefix()) / part)) << part;
    }
    EXPECT_FALSE(fs::exists(prefix() + "/share/kerf/assets/models/make_models.py"));
}

}  // namespace
}  // namespace kerf::app
