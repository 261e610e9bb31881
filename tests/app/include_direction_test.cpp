// Includes look back along the data flow only: gpu <- sim <- render <- ui <- app. Everybody may
// include shaders/shared; tests and benchmarks may include everything.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace kerf {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kFlow = {"gpu", "sim", "render", "ui", "app"};

/// The place of the folder of `path` along the flow, or nothing for other folders.
std::optional<std::size_t> rankOf(const fs::path& path) {
    const auto found = std::find(kFlow.begin(), kFlow.end(), path.begin()->string());
    if (found == kFlow.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - kFlow.begin());
}

bool mayInclude(const fs::path& from, const fs::path& included) {
    const std::optional<std::size_t> own = rankOf(from);
    const std::optional<std::size_t> other = rankOf(included);
    const bool testOnly = *included.begin() == "tests" || *included.begin() == "bench";
    return !own || (!testOnly && (!other || *other <= *own));
}

std::vector<fs::path> ourSources() {
    std::vector<fs::path> sources;
    for (const std::string_view folder : kFlow) {
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(KERF_SOURCE_DIR) / folder)) {
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") {
                sources.push_back(entry.path().lexically_relative(KERF_SOURCE_DIR));
            }
        }
    }
    std::sort(sources.begin(), sources.end());
    return sources;
}

/// What `source` includes in quotes, as paths from the top of the project.
std::vector<fs::path> includesOf(const fs::path& source) {
    static const std::regex kInclude("^\\s*#\\s*include\\s+\"([^\"]+)\".*");
    std::ifstream in(fs::path(KERF_SOURCE_DIR) / source);
    std::vector<fs::path> includes;
    std::smatch match;
    for (std::string line; std::getline(in, line);) {
        if (std::regex_match(line, match, kInclude)) {
            const fs::path beside = source.parent_path() / match[1].str();
            const bool isBeside = fs::exists(fs::path(KERF_SOURCE_DIR) / beside);
            includes.push_back((isBeside ? beside : fs::path(match[1].str())).lexically_normal());
        }
    }
    return includes;
}

TEST(IncludeDirection, RuleLooksBackOnly) {
    EXPECT_TRUE(mayInclude("sim/simulation.h", "gpu/buffer.h"));
    EXPECT_TRUE(mayInclude("sim/simulation.h", "sim/math.h"));
    EXPECT_TRUE(mayInclude("gpu/buffer.h", "shaders/shared/constraints.h"));
    EXPECT_FALSE(mayInclude("gpu/buffer.h", "sim/math.h"));
    EXPECT_FALSE(mayInclude("ui/panel.h", "app/session.h"));
    EXPECT_FALSE(mayInclude("app/main.cpp", "tests/support/gl_fixture.h"));
    EXPECT_TRUE(mayInclude("tests/app/some_test.cpp", "app/session.h"));
}

TEST(IncludeDirection, EverySourceKeepsTheRule) {
    std::size_t read = 0;
    for (const fs::path& source : ourSources()) {
        for (const fs::path& included : includesOf(source)) {
            ++read;
            EXPECT_TRUE(mayInclude(source, included))
                << source << " includes " << included << ", which lies ahead of it";
        }
    }
    EXPECT_GT(read, 50u) << "hardly any #include found below " << KERF_SOURCE_DIR;
}

}  // namespace
}  // namespace kerf
