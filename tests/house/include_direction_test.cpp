// Includes look back along the data flow only, in C++ and in shaders; tests and benchmarks may
// include everything and nobody includes them.

namespace kerf {
namespace {

/// All rooms, each of which may include itself and what stands before it. A file belongs to the
/// longest path that it lies below, so the words of a folder may stand before its rooms (sim/cut)
/// and what runs them behind (render, app).
const std::vector<fs::path> kRooms = {
    "shaders/shared",
    "shaders/sim/base",
    "shaders/sim/constraints",
    "shaders/sim",
    "shaders/sim/contact",
    "shaders/sim/boxes",
    "shaders/sim/unfold",
    "shaders/sim/implicit",
    "shaders/sim/paper_contact",
    "shaders/doctor",
    "shaders/render",
    "gpu",
    "sim/base",
    "sim/mesh",
    "sim/cut",
    "sim/cut/exact",
    "sim/cut/surface",
    "sim/cut/plan/input",
    "sim/cut/plan/strip",
    "sim/cut/plan/curves",
    "sim/cut/plan/wall",
    "sim/cut/plan",
    "sim/cut/commit",
    "sim/cut/patch",
    "sim/cut/cleanup",
    "sim/cut/stroke",
    "sim/repair",
    "sim/body",
    "sim/contact",
    "sim/solve/implicit",
    "sim/solve",
    "sim/run/start",
    "sim/run/parts",
    "sim/run/undo",
    "sim/run/blade",
    "sim/run/tear",
    "sim/run",
    "render/scene",
    "render/passes",
    "render",
    "ui/base",
    "ui/plots",
    "ui/state",
    "ui/panels",
    "ui",
    "app/files/io",
    "app/files/jobs",
    "app/files/import",
    "app/files/export",
    "app/files/film",
    "app/import/repair",
    "app/import",
    "app/link",
    "app/practice",
    "app/session",
    "app/journal",
    "app/regression",
    "app/study",
    "app/doctor",
    "app/scene/document",
    "app/scene/timeline",
    "app/scene/readout",
    "app/scene",
    "app/tools",
    "app/editor/steps",
    "app/editor/storage",
    "app/editor/view",
    "app/editor",
    "app/window",
    "app/cli/replay",
    "app/cli",
    "app",
};

/// The place in kRooms of the folder of `path`, or nothing for files in none of them.
std::optional<std::size_t> rankOf(const fs::path& path) {
    for (fs::path folder = path.parent_path(); !folder.empty(); folder = folder.parent_path()) {
        const auto found = std::find(kRooms.begin(), kRooms.end(), folder);
        if (found != kRooms.end()) {
            return static_cast<std::size_t>(found - kRooms.begin());
        }
    }
    return std::nullopt;
}

bool mayInclude(const fs::path& from, const fs::path& included) {
    const std::optional<std::size_t> own = rankOf(from);
    const std::optional<std::size_t> other = rankOf(included);
    const bool testOnly = *included.begin() == "tests" || *included.begin() == "bench";
    return !own || (!testOnly && (!other || *other <= *own));
}

std::vector<fs::path> ourSources() {
    const std::set<fs::path> kEndings = {".cpp", ".h", ".comp", ".frag", ".glsl", ".vert"};
    std::vector<fs::path> sources;
    for (const char* folder : {"shaders", "gpu", "sim", "render", "ui", "app"}) {
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(KERF_SOURCE_DIR) / folder)) {
            if (kEndings.contains(entry.path().extension())) {
                sources.push_back(entry.path().lexically_relative(KERF_SOURCE_DIR));
            }
        }
    }
    std::sort(sources.begin(), sources.end());
    return sources;
}

/// What `source` includes in quotes, as paths from the top of the project. Shaders find it beside
/// them, below shaders/ and below shaders/shared.
std::vector<fs::path> includesOf(const fs::path& source) {
    static const std::regex kInclude("^\\s*#\\s*include\\s+\"([^\"*]+)\".*");
    std::ifstream in(fs::path(KERF_SOURCE_DIR) / source);
    std::vector<fs::path> includes;
    std::smatch match;
    for (std::string line; std::getline(in, line);) {
        if (std::regex_match(line, match, kInclude)) {
            const std::string name = match[1];
            const fs::path places[] = {source.parent_path() / name, name,
                                       "shaders" / fs::path(name),
                                       "shaders/shared" / fs::path(name)};
            const auto* const found = std::ranges::find_if(places, [](const fs::path& place) {
                return fs::exists(fs::path(KERF_SOURCE_DIR) / place);
            });
            includes.push_back(
                (found != std::end(places) ? *found : fs::path(name)).lexically_normal());
        }
    }
    return includes;
}

TEST(IncludeDirection, RuleLooksBackOnly) {
    EXPECT_TRUE(mayInclude("sim/run/simulation.h", "gpu/buffer.h"));
    EXPECT_TRUE(mayInclude("sim/run/simulation.h", "sim/base/math.h"));
    EXPECT_TRUE(mayInclude("gpu/buffer.h", "shaders/shared/constraints.h"));
    EXPECT_TRUE(mayInclude("shaders/sim/measure.comp", "shaders/sim/base/fetch.glsl"));
    EXPECT_FALSE(mayInclude("shaders/sim/measure.comp", "shaders/sim/unfold/spin.glsl"));
    EXPECT_FALSE(mayInclude("gpu/buffer.h", "sim/base/math.h"));
    EXPECT_FALSE(mayInclude("sim/mesh/surface_mesh.h", "sim/run/simulation.h"));
    EXPECT_TRUE(mayInclude("sim/cut/plan/input/step.h", "sim/cut/cut_types.h"));
    EXPECT_FALSE(mayInclude("sim/cut/cut_types.h", "sim/cut/plan/input/step.h"));
    EXPECT_FALSE(mayInclude("ui/panel.h", "app/session/session.h"));
    EXPECT_FALSE(mayInclude("app/files/io/file_io.h", "app/files/import/model_source.h"));
    EXPECT_FALSE(mayInclude("app/main.cpp", "tests/support/gl_fixture.h"));
    EXPECT_FALSE(mayInclude("app/main.cpp", "tests/support/reference/reference_solver.h"));
    EXPECT_FALSE(mayInclude("app/cli/cli.cpp", "bench/timing.h"));
    EXPECT_TRUE(mayInclude("bench/timing.h", "app/session/session.h"));
    EXPECT_TRUE(mayInclude("tests/app/some_test.cpp", "app/session/session.h"));
}

TEST(IncludeDirection, EverySourceLiesInARoom) {
    for (const fs::path& source : ourSources()) {
        EXPECT_TRUE(rankOf(source)) << source << " lies in a folder without a place in kRooms";
    }
}

TEST(IncludeDirection, EverySourceKeepsTheRule) {
    std::size_t read = 0;
    for (const fs::path& source : ourSources()) {
        for (const fs::path& included : includesOf(source)) {
            ++read;
            EXPECT_TRUE(mayInclude(source, included))
                << source << " includes " << included << ", which lies ahead of it";
            EXPECT_TRUE(fs::exists(fs::path(KERF_SOURCE_DIR) / included))
                << source << " includes " << included << ", whose path is not from the top";
        }
    }
    EXPECT_GT(read, 1000u) << "hardly any #include found below " << KERF_SOURCE_DIR;
}

}  // namespace
}  // namespace kerf
