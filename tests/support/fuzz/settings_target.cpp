#include "app/editor/storage/settings_file.h"
#include "app/files/io/errors.h"
#include "tests/support/fuzz/refusal.h"
#include "tests/support/fuzz/targets.h"
#include "tests/support/fuzz/text_mutator.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace {

/// A folder with files that the list of recent files may name.
const TemporaryFolder& settingsFolder() {
    static const auto filled = [] {
        auto made = std::make_unique<TemporaryFolder>();
        for (const char* name : {"a.obj", "b.obj", "c d.kerf.json"}) {
            writeText(*made / name, "x");
        }
        return made;
    }();
    return *filled;
}

}  // namespace

FuzzOutcome readSettingsText(const std::string& text) {
    ui::Settings settings;
    try {
        settings = app::parseSettings(text);
    } catch (const app::InputError& error) {
        return refusedWith(error.what());
    }
    const std::string written = app::formatSettings(settings);
    return {true,
            app::parseSettings(written) == settings ? "" : "It reads back otherwise: " + written};
}

std::vector<std::string> settingsTexts() {
    ui::Settings other;
    other.theme = ui::Theme::light;
    other.mouse = ui::MouseScheme::blender;
    other.uiScale = 1.25;
    other.plots = {};
    return {app::formatSettings({}), app::formatSettings(other), R"({"theme": "light"})"};
}

std::vector<std::string> settingsWords() {
    return jsonWordsOf(settingsTexts());
}

FuzzOutcome readRecentText(const std::string& text) {
    const std::filesystem::path store = settingsFolder() / "recent-files";
    writeText(store, text);
    app::RecentFiles recent(store);
    recent.add(settingsFolder() / "a.obj");
    if (recent.files().size() > app::RecentFiles::kMost) {
        return {true, "It has too many files."};
    }
    const app::RecentFiles again(store);
    return {true, again.files() == recent.files() ? "" : "It reads back otherwise."};
}

std::vector<std::string> recentTexts() {
    const std::string path = settingsFolder().path().string() + "/";
    return {"", path + "b.obj\n" + path + "c d.kerf.json\n" + path + "gone.obj\n"};
}

std::vector<std::string> recentWords() {
    return {"\n",        "/",
            "..",        "~",
            "/dev/zero", settingsFolder().path().string(),
            "b.obj",     std::string(1, '\0')};
}

}  // namespace kerf::test
