#include "gpu/numbers_table.h"

#include <gtest/gtest.h>

#include "gpu/data_path.h"
#include "gpu/program.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/variable.h"

namespace kerf::gpu {
namespace {

constexpr std::uint32_t kDispatches = 3000;  // more than a table has places

/// A kernel that adds 1 to a word as often as its first number says.
class NumbersTableTest : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        std::filesystem::create_directories(folder_ / "shaders/sim");
        test::writeText(folder_ / "shaders/sim/base/numbers.glsl",
                        test::readBytes(shaderRoot() / "sim/base/numbers.glsl"));
        test::writeText(folder_ / "shaders/count.comp",
                        "layout(local_size_x = 1) in;\n"
                        "#include \"sim/base/numbers.glsl\"\n"
                        "layout(std430, binding = 0) buffer Words { uint words[]; };\n"
                        "void main() {\n"
                        "    for (uint i = 0u; i < numbers.x; ++i) words[numbers.y] += numbers.z;\n"
                        "}\n");
        std::filesystem::create_directory_symlink(dataPath("assets"), folder_ / "assets");
        data_.emplace("KERF_DATA_DIR", folder_.path().string());
    }
    void TearDown() override {
        data_.reset();
        GlTest::TearDown();
    }

    test::TemporaryFolder folder_;
    std::optional<test::Variable> data_;
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
