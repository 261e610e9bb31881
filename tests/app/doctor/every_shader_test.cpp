// Every shader that Kerf can come to compile, seen by the reference compiler of GLSL and held
// against what Kerf asks of a driver.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "app/doctor/every_program.h"
#include "gpu/data_path.h"
#include "gpu/limits.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/program_output.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/variable.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

using ::testing::HasSubstr;
using ::testing::Not;

class EveryShader : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (programs().empty()) {
            for (const char* way : {"images", "shared"}) {
                const test::Variable kernels("KERF_KERNELS", way);
                std::ranges::copy(everyProgram(), std::back_inserter(programs()));
            }
        }
    }
    /// Of both ways; linked once for all tests.
    static std::vector<gpu::LinkedProgram>& programs() {
        static std::vector<gpu::LinkedProgram> linked;
        return linked;
    }
    /// The texts, each once, with the file that it comes from.
    static std::map<std::string, std::string> texts() {
        std::map<std::string, std::string> all;
        for (const gpu::LinkedProgram& program : programs()) {
            for (const gpu::LinkedStage& stage : program.stages) {
                all.emplace(stage.text, stage.file);
            }
        }
        return all;
    }
};

TEST_F(EveryShader, IsAcceptedByTheReferenceCompiler) {
    const test::TemporaryFolder folder;
    std::string command = "glslangValidator";
    for (const auto& [text, file] : texts()) {
        std::string name =
            std::to_string(command.size()) + "-" + fs::path(file).filename().string();
        test::writeText(folder / name, text);
        command.append(" ").append((folder / name).string());
    }
    ASSERT_THAT(texts().size(), ::testing::Gt(300u));
    const std::string said = test::outputOf(command + " 2>&1");
    EXPECT_THAT(said.substr(0, 4000), Not(HasSubstr("ERROR")));
    EXPECT_THAT(said, Not(HasSubstr("failed")));
}

TEST_F(EveryShader, OfTheFoldersIsAmongThem) {
    std::set<std::string> linked;
    for (const auto& [text, file] : texts()) {
        linked.insert(file);
    }
    for (const auto& entry : fs::recursive_directory_iterator(gpu::shaderRoot())) {
        const std::string ending = entry.path().extension().string();
        if (ending == ".comp" || ending == ".vert" || ending == ".frag") {
            EXPECT_EQ(linked.count(fs::relative(entry.path(), gpu::shaderRoot()).string()), 1u)
                << entry.path();
        }
    }
}

/// The words that decide what is compiled, of all shaders.
std::set<std::string> switchesIn(const fs::path& folder) {
    static const std::regex word("^#(?:ifdef|ifndef|if|elif)\\b(.*)$", std::regex::multiline);
    static const std::regex name("\\b[A-Z][A-Z_]+\\b");
    std::set<std::string> switches;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string text = entry.is_regular_file() ? test::readBytes(entry.path()) : "";
        for (std::sregex_iterator line(text.begin(), text.end(), word), end; line != end; ++line) {
            const std::string condition = (*line)[1];
            for (std::sregex_iterator at(condition.begin(), condition.end(), name); at != end;
                 ++at) {
                switches.insert(at->str());
            }
        }
    }
    std::erase_if(switches, [](const std::string& s) { return s.starts_with("KERF_"); });
    return switches;
}

TEST_F(EveryShader, IsThereWithEachSwitchOnAndOff) {
    std::set<std::string> inside{"BUMPS"};  // that shaders define themselves
    for (const std::string& each : switchesIn(gpu::shaderRoot())) {
        const auto has = [&](const gpu::LinkedProgram& program) {
            return std::ranges::count(program.defines, each, [](const auto& d) { return d.first; });
        };
        if (inside.count(each) == 0) {
            EXPECT_TRUE(std::ranges::any_of(programs(), has)) << each;
        }
    }
}

/// What kernels share in a work group, as they declare it [bytes].
int sharedBytes(const std::string& text) {
    static const std::regex declared("\\nshared (float|uint|vec2|vec4) \\w+\\[(\\w+)\\];");
    static const std::map<std::string, int> sizes{
        {"float", 4}, {"uint", 4}, {"vec2", 8}, {"vec4", 16}};
    int bytes = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), declared), end; at != end; ++at) {
        const std::string count = (*at)[2];
        std::smatch value;
        EXPECT_TRUE(std::regex_search(text, value, std::regex("uint " + count + " = (\\d+)u")))
            << count;
        bytes += sizes.at((*at)[1]) * std::stoi(value[1]);
    }
    return bytes;
}

/// The most that any shader needs, by OpenGL's name of the limit.
std::map<std::string, std::int64_t> mostNeeded(const std::vector<gpu::LinkedProgram>& programs) {
    std::map<std::string, std::int64_t> most;
    const auto raise = [&](const std::string& limit, int needs) {
        most[limit] = std::max<std::int64_t>(most[limit], needs);
    };
    for (const gpu::LinkedProgram& program : programs) {
        for (const gpu::LinkedStage& stage : program.stages) {
            const std::string ending = fs::path(stage.file).extension();
            const std::string kind = ending == ".comp"   ? "COMPUTE"
                                     : ending == ".vert" ? "VERTEX"
                                                         : "FRAGMENT";
            raise("GL_MAX_" + kind + "_SHADER_STORAGE_BLOCKS", stage.needs.storageBuffers);
            raise(kind == "FRAGMENT" ? "GL_MAX_TEXTURE_IMAGE_UNITS"
                                     : "GL_MAX_" + kind + "_TEXTURE_IMAGE_UNITS",
                  stage.needs.textures);
            raise("GL_MAX_" + kind + "_IMAGE_UNIFORMS", stage.needs.images);
            raise("GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS", stage.needs.threads);
            raise("GL_MAX_COMPUTE_SHARED_MEMORY_SIZE", sharedBytes(stage.text));
        }
    }
    return most;
}

TEST_F(EveryShader, NeedsWhatKerfAsksOfADriver) {
    for (const char* way : {"images", "shared"}) {
        const test::Variable kernels("KERF_KERNELS", way);
        const std::map<std::string, std::int64_t> most = mostNeeded(everyProgram());
        for (const gpu::DriverLimit& limit : gpu::driverLimits()) {
            const auto found = most.find(limit.name);
            if (found != most.end()) {
                EXPECT_EQ(limit.needs, found->second) << limit.name << ", " << way;
            }
        }
        for (const auto& [name, needs] : most) {
            EXPECT_TRUE(needs == 0 || std::ranges::count(gpu::driverLimits(), name,
                                                         [](const gpu::DriverLimit& limit) {
                                                             return std::string(limit.name);
                                                         }) == 1)
                << name << " " << needs << " is not asked for";
        }
    }
}

}  // namespace
}  // namespace kerf::app
