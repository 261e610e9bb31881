#include "app/editor/storage/settings_file.h"

#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/session/session_json.h"
#include "gpu/data_path.h"
#include "ui/state/action_table.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;
using ui::Settings;

constexpr std::uintmax_t kMostSettingsBytes = 1u << 20;
constexpr std::size_t kMostNames = 64;
constexpr std::size_t kMostTexts = 200;

struct NumberRow {
    const char* key;
    double Settings::*member;
    double low;
    double high;
};
constexpr std::array kNumbers{
    NumberRow{"ui_scale", &Settings::uiScale, 0.5, 4},
    NumberRow{"controls_width", &Settings::controlsWidth, Settings::kLeastWidth,
              Settings::kMostWidth},
    NumberRow{"readings_width", &Settings::readingsWidth, Settings::kLeastWidth,
              Settings::kMostWidth},
    NumberRow{"pieces_share", &Settings::piecesShare, 0, 1},
    NumberRow{"plots_share", &Settings::plotsShare, 0, 1},
};

struct SwitchRow {
    const char* key;
    bool Settings::*member;
};
constexpr std::array kSwitches{
    SwitchRow{"show_controls", &Settings::showControls},
    SwitchRow{"show_readings", &Settings::showReadings},
    SwitchRow{"time_runs_while_cutting", &Settings::timeRunsWhileCutting},
    SwitchRow{"keep_journal", &Settings::keepsJournal},
    SwitchRow{"show_expert", &Settings::showExpert},
    SwitchRow{"show_last_try", &Settings::showLastTry},
    SwitchRow{"software_renderer", &Settings::softwareRenderer},
};

struct NamesRow {
    const char* key;
    std::vector<std::string> Settings::*member;
};
constexpr std::array kNames{
    NamesRow{"plots", &Settings::plots},
    NamesRow{"folded", &Settings::folded},
};

/// Visits the rows of all kinds.
template <class Visit>
void forEachRow(Visit visit) {
    std::ranges::for_each(kNumbers, visit);
    std::ranges::for_each(kSwitches, visit);
    std::ranges::for_each(kNames, visit);
}

[[noreturn]] void fail(const std::string& key, const std::string& problem) {
    throw InputError(key + ": " + problem);
}

double read(const NumberRow& row, const nlohmann::json& value) {
    const double number = value.is_number() ? value.get<double>() : row.low - 1;
    if (!(number >= row.low && number <= row.high)) {
        fail(row.key, "expected a number from " + formatNumber(row.low) + " to " +
                          formatNumber(row.high) + ".");
    }
    return number;
}

bool read(const SwitchRow& row, const nlohmann::json& value) {
    if (!value.is_boolean()) {
        fail(row.key, "expected true or false.");
    }
    return value.get<bool>();
}

std::vector<std::string> read(const NamesRow& row, const nlohmann::json& value) {
    const auto isName = [](const nlohmann::json& entry) { return entry.is_string(); };
    if (!value.is_array() || value.size() > kMostNames || !std::ranges::all_of(value, isName)) {
        fail(row.key, "expected a list of names.");
    }
    return value.get<std::vector<std::string>>();
}

std::map<std::string, std::string> readTexts(const nlohmann::json& value, const char* key,
                                             const char* expected, auto fits) {
    const auto isFit = [&](const nlohmann::json& entry) {
        return entry.is_string() && fits(entry.get<std::string>());
    };
    if (!value.is_object() || value.size() > kMostTexts || !std::ranges::all_of(value, isFit)) {
        fail(key, expected);
    }
    return value.get<std::map<std::string, std::string>>();
}

ui::Theme readTheme(const nlohmann::json& value) {
    if (value == "dark") {
        return ui::Theme::dark;
    }
    if (value == "light") {
        return ui::Theme::light;
    }
    fail("theme", "expected \"dark\" or \"light\".");
}

ui::MouseScheme readMouse(const nlohmann::json& value) {
    const auto row = std::ranges::find_if(
        ui::kMouseTable, [&](const ui::MouseSchemeRow& r) { return value == std::string(r.id); });
    if (row == ui::kMouseTable.end()) {
        fail("mouse", "expected \"kerf\", \"blender\" or \"cad\".");
    }
    return static_cast<ui::MouseScheme>(row - ui::kMouseTable.begin());
}

std::string readPerson(const nlohmann::json& value) {
    if (!value.is_string()) {
        fail("person", "expected a name in quotes.");
    }
    return value.get<std::string>();
}

ui::WindowPlace readPlace(const nlohmann::json& value) {
    const auto fits = [](const nlohmann::json& number) {
        return number.is_number_integer() && number >= -100'000 && number <= 100'000;
    };
    if (!value.is_array() || value.size() != 5 || !std::ranges::all_of(value, fits)) {
        fail("window", "expected five whole numbers from -100000 to 100000.");
    }
    return {value[0], value[1], value[2], value[3], value[4] != 0};
}

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostListBytes = 1u << 20;

bool isThere(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error);
}

std::string contentOf(const fs::path& store) {
    try {
        return store.empty() ? "" : readInputFile(store, kMostListBytes);
    } catch (const InputError&) {  // there is none yet
        return "";
    }
}

}  // namespace

std::string formatSettings(const Settings& settings) {
    Json json;
    json["theme"] = settings.theme == ui::Theme::light ? "light" : "dark";
    json["mouse"] = std::string(rowOf(settings.mouse).id);
    if (const ui::WindowPlace& at = settings.place; at.width > 0) {
        json["window"] = {at.x, at.y, at.width, at.height, at.maximized ? 1 : 0};
    }
    json["folders"] = settings.folders;
    json["keys"] = settings.keys;
    json["person"] = settings.person;
    forEachRow([&](const auto& row) { json[row.key] = settings.*row.member; });
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Settings parseSettings(const std::string& text) {
    const nlohmann::json json = parseJson(text);
    if (!json.is_object()) {
        throw InputError("expected an object in braces.");
    }
    Settings settings;
    if (json.contains("theme")) {
        settings.theme = readTheme(json["theme"]);
    }
    if (json.contains("mouse")) {
        settings.mouse = readMouse(json["mouse"]);
    }
    if (json.contains("window")) {
        settings.place = readPlace(json["window"]);
    }
    if (json.contains("folders")) {
        settings.folders =
            readTexts(json["folders"], "folders", "expected folders by name, in braces.",
                      [](const std::string&) { return true; });
    }
    if (json.contains("keys")) {
        settings.keys = readTexts(
            json["keys"], "keys",
            "expected letters, digits and F1 to F12 by action, such as {\"Remesh\": \"Ctrl+M\"}.",
            [](const std::string& keys) { return ui::shortcutOf(keys).has_value(); });
    }
    if (json.contains("person")) {
        settings.person = readPerson(json["person"]);
    }
    forEachRow([&](const auto& row) {
        if (json.contains(row.key)) {
            settings.*row.member = read(row, json[row.key]);
        }
    });
    return settings;
}

SettingsFile::SettingsFile(std::filesystem::path file) : file_(std::move(file)) {
    std::error_code error;
    if (!file_.empty() && std::filesystem::exists(file_, error)) {
        try {
            now = parseSettings(readInputFile(file_, kMostSettingsBytes));
        } catch (const InputError& problem) {
            problem_ = "The settings in " + file_.string() +
                       " can't be read, so the defaults are used: " + problem.what();
        }
    }
    saved_ = now;
}

std::string SettingsFile::save() {
    if (file_.empty() || now == saved_) {
        return "";
    }
    saved_ = now;
    try {
        std::filesystem::create_directories(file_.parent_path());
        writeOutputFile(file_, formatSettings(now));
        return "";
    } catch (const std::exception& problem) {
        return std::string("The settings could not be saved: ") + problem.what();
    }
}

std::filesystem::path defaultSettingsFile() {
    return gpu::userPath("XDG_CONFIG_HOME", ".config", "settings.json");
}

RecentFiles::RecentFiles(fs::path store) : store_(std::move(store)) {
    std::istringstream in(contentOf(store_));
    for (std::string line; files_.size() < kMost && std::getline(in, line);) {
        if (!line.empty()) {
            files_.emplace_back(line);
        }
    }
    look();
}

void RecentFiles::add(const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::absolute(file, error).lexically_normal();
    if (error || whole.string().find('\n') != std::string::npos) {
        return;
    }
    std::erase(files_, whole);
    files_.insert(files_.begin(), whole);
    files_.resize(std::min(files_.size(), kMost));
    look();
    write();
}

void RecentFiles::write() const {
    if (store_.empty()) {
        return;
    }
    std::error_code error;
    fs::create_directories(store_.parent_path(), error);
    std::string lines;
    for (const fs::path& file : files_) {
        lines += file.string() + '\n';
    }
    try {
        writeOutputFile(store_, lines);
    } catch (const OutputError&) {  // a convenience, see add()
    }
}

void RecentFiles::look() {
    there_.clear();
    std::ranges::copy_if(files_, std::back_inserter(there_), isThere);
}

std::vector<fs::path> RecentFiles::folders() const {
    std::vector<fs::path> folders;
    for (const fs::path& file : files()) {
        if (std::ranges::find(folders, file.parent_path()) == folders.end()) {
            folders.push_back(file.parent_path());
        }
    }
    return folders;
}

fs::path recentFilesStore() {
    return gpu::statePath("recent-files");
}

}  // namespace kerf::app
