#include "gpu/program.h"

#include "gpu/buffer.h"
#include "gpu/data_path.h"
#include "gpu/numbers_table.h"
#include "gpu/shader_source.h"
#include "gpu/traffic.h"

namespace kerf::gpu {
namespace {

/// A folder for shaders that a test writes.
class ProgramTest : public GlTest {
  protected:
    std::string write(const std::string& name, const std::string& text) {
        writeText(folder_ / name, text);
        return folder_ / name;
    }

    std::string failureOf(const std::string& path) {
        try {
            Program::compute(path);
        } catch (const ShaderError& error) {
            return error.what();
        }
        return "compiled";
    }

    TemporaryFolder folder_;
};

const std::string kMain = "layout(local_size_x = 1) in;\nvoid main() {}\n";

std::string testShader(const std::string& name) {
    return std::string(KERF_SOURCE_DIR) + "/tests/gpu/shaders/" + name;
}

/// Value i is 3 i + 5, of so many.
Program scaleProgram(std::uint32_t count) {
    Program program = Program::compute(testShader("scale.comp"), {{"OFFSET", "5u"}});
    program.set("count", count);
    program.set("factor", 3u);
    return program;
}

// Drivers leave such a dispatch out, and all goes on without its results.
TEST_F(ProgramTest, MoreGroupsThanTheDriverTakesAreRefused) {
    const Program program = Program::compute(write("many.comp", kMain));
    GLint most = 0;
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &most);
    program.dispatchGroups(2);
    if (most < std::numeric_limits<GLint>::max()) {
        EXPECT_THROW(program.dispatchGroups(static_cast<std::uint32_t>(most) + 1), OutOfMemory);
        EXPECT_THROW(program.dispatch(static_cast<std::uint32_t>(most) + 1), OutOfMemory);
    }
}

TEST_F(ProgramTest, DispatchCoversEveryThreadWithUniformsAndDefines) {
    Buffer values;
    values.resize(200 * sizeof(std::uint32_t));
    values.bindStorage(0);
    const Program program = scaleProgram(129);
    program.dispatch(0);
    EXPECT_THAT(values.read<std::uint32_t>(0, 200), Each(0u));
    program.dispatch(129);
    EXPECT_THAT(values.read<std::uint32_t>(127, 4), ElementsAre(386u, 389u, 0u, 0u));
}

TEST_F(ProgramTest, BufferCallsAfterADispatchShareABarrier) {
    Buffer values;
    values.resize(4 * sizeof(std::uint32_t));
    values.bindStorage(0);
    const Program program = scaleProgram(4);
    for (int i = 0; i < 2; ++i) {
        program.dispatch(4);
        const Traffic before = traffic();
        EXPECT_THAT(values.read<std::uint32_t>(2, 2), ElementsAre(11u, 14u));
        values.write<std::uint32_t>(3, std::vector{1u});
        EXPECT_THAT(values.read<std::uint32_t>(2, 2), ElementsAre(11u, 1u));
        EXPECT_EQ((traffic() - before).barriers, 1u);
    }
}

TEST_F(ProgramTest, UnknownUniformIsIgnored) {
    const Program program = Program::compute(write("plain.comp", kMain));
    program.set("removed_by_the_linker", 1.0f);
}

TEST_F(ProgramTest, ErrorsNameFileAndLine) {
    const std::string path = write("broken.comp", "\n\n  nonsense here;\n" + kMain);
    EXPECT_THAT(failureOf(path), StartsWith(path + ":3: "));
    write("bad.glsl", "float good() { return 1.0; }\nfloat bad() { return missing; }\n");
    EXPECT_THAT(failureOf(write("whole.comp", "#include \"bad.glsl\"\n" + kMain)),
                StartsWith((folder_ / "bad.glsl").string() + ":2: "));
    write("part.glsl", "float good() { return 1.0; }\n\n\n");
    const std::string behind = write(
        "behind.comp", "\n#include \"part.glsl\"\n\nfloat bad() { return missing; }\n" + kMain);
    EXPECT_THAT(failureOf(behind), StartsWith(behind + ":4: "));
}

TEST_F(ProgramTest, MissingFilesAndAnIncludeOfItselfAreNamedWithTheirPlace) {
    const std::string path = write("whole.comp", "\n#include \"absent.glsl\"\n" + kMain);
    EXPECT_EQ(failureOf(path), path + ":2: the file \"absent.glsl\" to include was not found");
    const std::string loop = write("loop.comp", "#include \"loop.comp\"\n" + kMain);
    EXPECT_EQ(failureOf(loop), loop + ":1: \"loop.comp\" includes itself");
    EXPECT_THAT(failureOf("absent.comp"), HasSubstr("absent.comp cannot be read"));
}

TEST_F(ProgramTest, AStarIncludesAllFilesOfAFolderByName) {
    fs::create_directory(folder_ / "parts");
    write("parts/b.glsl", "const int kB = kA;\n");
    write("parts/a.glsl", "const int kA = 1;\n");
    write("parts/other.txt", "nonsense\n");
    EXPECT_EQ(failureOf(write("all.comp", "#include \"parts/*.glsl\"\n" + kMain)), "compiled");
    write("once.glsl", "#pragma once\nconst int kOnce = 1;\n");
    EXPECT_EQ(
        failureOf(write("twice.comp", "#include \"once.glsl\"\n#include \"once.glsl\"\n" + kMain)),
        "compiled");
}

TEST_F(ProgramTest, LinkErrorNamesTheShaders) {
    const std::string vertex = write("a.vert", "out vec2 v;\nvoid main() { v = vec2(1); }\n");
    const std::string fragment =
        write("a.frag", "in vec3 v;\nout vec4 c;\nvoid main() { c = vec4(v, 1); }\n");
    try {
        Program::graphics(vertex, fragment);
        FAIL() << "linked";
    } catch (const ShaderError& error) {
        EXPECT_THAT(error.what(), HasSubstr("a.vert with "));
        EXPECT_THAT(error.what(), HasSubstr("does not link"));
    }
}

TEST(ExplainLog, KnowsTheFormsOfTheDrivers) {
    const std::vector<std::string> files = {"shaders/a.comp", "shaders/b.glsl"};
    EXPECT_EQ(explainLog("0:100012(5): error: x undeclared", files),
              "shaders/b.glsl:12: error: x undeclared");
    EXPECT_EQ(explainLog("0(7) : error C0000: syntax error", files),
              "shaders/a.comp:7: error C0000: syntax error");
    EXPECT_EQ(explainLog("ERROR: 0:100003: 'x' : undeclared", files),
              "shaders/b.glsl:3: 'x' : undeclared");
    EXPECT_EQ(explainLog("no more errors", files), "no more errors");
}

TEST(DataPath, EnvironmentDecides) {
    setenv("KERF_DATA_DIR", "/elsewhere", 1);
    EXPECT_EQ(dataPath("assets/models"), "/elsewhere/assets/models");
    unsetenv("KERF_DATA_DIR");
    EXPECT_TRUE(fs::exists(dataPath("shaders/shared/shared_types.h")));
}

TEST_F(ProgramTest, AShelfGivesOneProgramForTheSameSources) {
    const std::string path = write("kernel.comp", kMain);
    const auto make = [&] { return Program::compute(path); };
    {
        const ProgramShelf shelf;
        const Program first = make();
        EXPECT_EQ(make().id(), first.id());
        EXPECT_NE(Program::compute(path, {{"OTHER", "1"}}).id(), first.id());
    }
    const Program first = make();
    EXPECT_NE(make().id(), first.id()) << "without a shelf each has its own";
}

constexpr std::uint32_t kDispatches = 3000;  // more than a table has places

/// A kernel that adds 1 to a word as often as its first number says.
class NumbersTableTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        fs::create_directories(folder_ / "shaders/sim/base");
        writeText(folder_ / "shaders/sim/base/numbers.glsl",
                  readBytes(shaderRoot() / "sim/base/numbers.glsl"));
        writeText(folder_ / "shaders/count.comp",
                  "layout(local_size_x = 1) in;\n"
                  "#include \"sim/base/numbers.glsl\"\n"
                  "layout(std430, binding = 0) buffer Words { uint words[]; };\n"
                  "void main() {\n"
                  "    for (uint i = 0u; i < numbers.x; ++i) words[numbers.y] += numbers.z;\n"
                  "}\n");
        fs::create_directory_symlink(dataPath("assets"), folder_ / "assets");
        data_.emplace("KERF_DATA_DIR", folder_.path().string());
    }
    void TearDown() override {
        data_.reset();
        GlTest::TearDown();
    }

    TemporaryFolder folder_;
    std::optional<Variable> data_;
};

// On zink a loop over a plain uniform kept the first number of its turns.
TEST_F(NumbersTableTest, EachDispatchSeesItsOwn) {
    const Program count = Program::compute("count.comp");
    Buffer words;
    words.assign(std::vector<std::uint32_t>(kDispatches));
    words.bindStorage(0);
    std::vector<std::uint32_t> expected(kDispatches);
    for (std::uint32_t i = 0; i < kDispatches; ++i) {
        const std::uint32_t turns = i % 23;
        const std::uint32_t word = i * 7 % kDispatches;
        count.setNumbers({turns, word, i});
        count.dispatch(1);
        expected[word] += turns * i;
    }
    EXPECT_EQ(words.read<std::uint32_t>(0, kDispatches), expected);
}

}  // namespace
}  // namespace kerf::gpu
