// What scripts/format holds in C++ holds in shaders too, which it does not read.

namespace kerf {
namespace {

constexpr std::size_t kColumns = 100;  // as ColumnLimit in .clang-format

/// Expects short lines in all files below `folder`; returns how many files there are.
int expectShortLines(const fs::path& folder) {
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) {
            continue;
        }
        ++files;
        std::ifstream in(entry.path());
        int number = 0;
        for (std::string line; std::getline(in, line);) {
            ++number;
            EXPECT_LE(line.size(), kColumns)
                << entry.path().lexically_relative(KERF_SOURCE_DIR).string() << ":" << number;
        }
    }
    return files;
}

TEST(ShaderColumns, NoLineIsLongerThanInCpp) {
    EXPECT_GT(expectShortLines(fs::path(KERF_SOURCE_DIR) / "shaders"), 100);
    EXPECT_GT(expectShortLines(fs::path(KERF_SOURCE_DIR) / "tests/gpu/shaders"), 0);
}

}  // namespace
}  // namespace kerf
