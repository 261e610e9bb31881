#include "app/study/study.h"

#include <nlohmann/json.hpp>

#include "app/files/io/encodings.h"
#include "app/files/io/file_io.h"
#include "app/session/session.h"
#include "app/session/session_json.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Settings = std::vector<Setting>;

constexpr std::uintmax_t kMaxStudyBytes = 16u << 20;
constexpr const char* kFormat = "kerf-sweep";

[[noreturn]] void fail(const std::string& place, const std::string& problem) {
    throw InputError(place + ": " + problem);
}

std::string placeOf(const std::string& list, std::size_t item) {
    return list + "[" + std::to_string(item) + "]";
}

const Json& require(const Json& top, const char* key) {
    if (!top.contains(key)) {
        fail(key, "this key is missing; add it.");
    }
    return top[key];
}

/// The items of a list that holds something.
const Json& requireList(const Json& list, const std::string& place, const char* what) {
    if (!list.is_array()) {
        fail(place, "expected a list in brackets.");
    }
    if (list.empty()) {
        fail(place, std::string("the list is empty; name at least one ") + what + ".");
    }
    return list;
}

const Json& requireObject(const Json& object, const std::string& place) {
    if (!object.is_object()) {
        fail(place, "expected an object in braces.");
    }
    return object;
}

void requireFormat(const Json& top) {
    if (require(top, "format") != kFormat) {
        fail("format", std::string("expected \"") + kFormat + "\"; this is some other file.");
    }
    if (require(top, "version") != 1) {
        fail("version", "expected 1; this kerf reads no other version.");
    }
}

void requireFewEnough(std::size_t count, const std::string& place) {
    if (count > kMostRuns) {
        fail(place, "these are more than " + std::to_string(kMostRuns) +
                        " runs; divide them into several studies.");
    }
}

// --- Sessions --------------------------------------------------------------------------------

/// Tells whether a session is wanted, by its number.
using Wanted = std::function<bool(std::size_t session)>;

/// Reads sessions, and each model that they share once.
class SessionShelf {
  public:
    explicit SessionShelf(fs::path folder) : folder_(std::move(folder)) {}

    StudySession read(const std::string& name) {
        StudySession session;
        session.name = name;
        const fs::path file = fs::absolute(folder_ / name).lexically_normal();
        const Session read = readSession(file);
        session.file = file;
        session.params = read.params;
        session.sha256 = sha256OfFile(file);
        const std::vector<fs::path> models = modelFiles(read);
        session.models = static_cast<int>(models.size());
        session.modelSha256 =
            joined(models, ",", [&](const fs::path& model) { return digestOf(model); });
        return session;
    }

  private:
    std::string digestOf(const fs::path& model) {
        std::string& digest = models_[model];
        if (digest.empty()) {
            digest = sha256OfFile(model);
        }
        return digest;
    }

    fs::path folder_;
    std::map<fs::path, std::string> models_;
};

std::string sessionName(const Json& name, const std::string& place) {
    if (!name.is_string()) {
        fail(place, "expected the name of a session file in quotes.");
    }
    auto file = name.get<std::string>();
    if (const std::string problem = problemWithPath(file); !problem.empty()) {
        fail(place, problem);
    }
    return file;
}

std::vector<StudySession> readSessions(const Json& list, const fs::path& folder,
                                       const Wanted& wanted) {
    SessionShelf shelf(folder);
    std::vector<StudySession> sessions;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string place = placeOf("sessions", i);
        sessions.emplace_back().name = sessionName(list[i], place);
        try {
            sessions[i] = wanted(i) ? shelf.read(sessions[i].name) : sessions[i];
        } catch (const InputError& error) {
            fail(place, error.what());
        }
    }
    return sessions;
}

// --- Parameters ------------------------------------------------------------------------------

void requireKnown(const std::string& name, const std::string& place) {
    Params scratch;
    if (findParam(name) == nullptr) {
        fail(place, setParam(scratch, shortened(name), std::monostate{}) + ".");
    }
}

/// The value as Kerf writes it, so that 0.10 and 0.1 are one.
Setting readSetting(const std::string& name, const Json& value, const std::string& place) {
    Params scratch;
    try {
        setParamFromText(scratch, name, value.dump());
    } catch (const InputError& error) {
        std::string problem = error.what();
        const std::string prefix = name + ": ";
        fail(place, problem.starts_with(prefix) ? problem.substr(prefix.size()) : problem);
    }
    return {name, valueText(getParam(scratch, name))};
}

/// What is set in the runs of each session, and the parameters that are set at all.
struct Variants {
    std::vector<Settings> runs;
    std::vector<std::string> parameters;
};

/// Each of `runs` with each of the values.
std::vector<Settings> crossed(const std::vector<Settings>& runs, const Settings& values) {
    std::vector<Settings> result;
    for (const Settings& run : runs) {
        for (const Setting& value : values) {
            result.push_back(run);
            result.back().push_back(value);
        }
    }
    return result;
}

/// All combinations; those of the last parameter stand together.
Variants readGrid(const Json& grid) {
    if (requireObject(grid, "grid").empty()) {
        fail("grid", "it is empty; name at least one parameter with its values.");
    }
    Variants variants{{{}}, {}};
    for (const auto& item : grid.items()) {
        const std::string place = "grid." + shortened(item.key());
        requireKnown(item.key(), place);
        const Json& list = requireList(item.value(), place, "value");
        requireFewEnough(variants.runs.size() * list.size(), "grid");
        Settings values;
        for (std::size_t i = 0; i < list.size(); ++i) {
            values.push_back(readSetting(item.key(), list[i], placeOf(place, i)));
        }
        variants.runs = crossed(variants.runs, values);
        variants.parameters.push_back(item.key());
    }
    return variants;
}

Settings readListedRun(const Json& run, const std::string& place) {
    Settings settings;
    for (const auto& item : requireObject(run, place).items()) {
        const std::string own = place + "." + shortened(item.key());
        requireKnown(item.key(), own);
        settings.push_back(readSetting(item.key(), item.value(), own));
    }
    return settings;
}

Variants readListedRuns(const Json& list) {
    requireFewEnough(requireList(list, "runs", "run").size(), "runs");
    Variants variants;
    for (std::size_t i = 0; i < list.size(); ++i) {
        variants.runs.push_back(readListedRun(list[i], placeOf("runs", i)));
        for (const Setting& setting : variants.runs.back()) {
            if (std::ranges::count(variants.parameters, setting.name) == 0) {
                variants.parameters.push_back(setting.name);
            }
        }
    }
    return variants;
}

Variants readVariants(const Json& top) {
    if (top.contains("grid") == top.contains("runs")) {
        fail("top level", "expected either \"grid\" or \"runs\".");
    }
    return top.contains("grid") ? readGrid(top["grid"]) : readListedRuns(top["runs"]);
}

// --- Runs ------------------------------------------------------------------------------------

/// A parameter of one model needs that model in each session that is read.
void requireModels(const Study& study) {
    for (const std::string& parameter : study.parameters) {
        for (const StudySession& session : study.sessions) {
            if (session.models > 0 && modelOf(parameter) >= session.models) {
                fail(shortened(parameter), shortened(session.name) + " has no model " +
                                               std::to_string(modelOf(parameter)) + ", only " +
                                               counted(session.models, "model", "models") +
                                               ", numbered from 0.");
            }
        }
    }
}

std::vector<StudyRun> makeRuns(std::size_t sessions, const std::vector<Settings>& variants) {
    std::vector<StudyRun> runs;
    for (std::size_t session = 0; session < sessions; ++session) {
        for (const Settings& settings : variants) {
            runs.push_back({session, settings});
        }
    }
    return runs;
}

std::vector<std::string> unknownKeys(const Json& top) {
    constexpr std::string_view kKnown[] = {"format", "version", "sessions", "grid", "runs"};
    std::vector<std::string> warnings;
    for (const auto& item : top.items()) {
        if (std::ranges::count(kKnown, item.key()) == 0) {
            warnings.push_back(shortened(item.key()) + ": unknown key, ignored.");
        }
    }
    return warnings;
}

Study parseStudy(const std::string& text, const fs::path& folder,
                 std::optional<std::size_t> onlyRun) {
    const Json top = parseOrderedJson(text);
    requireFormat(requireObject(top, "top level"));
    Variants variants = readVariants(top);
    const auto wanted = [&](std::size_t session) {
        return !onlyRun || *onlyRun / variants.runs.size() == session;
    };
    const Json& sessions = requireList(require(top, "sessions"), "sessions", "session");
    requireFewEnough(sessions.size() * variants.runs.size(), "sessions");
    Study study;
    study.sessions = readSessions(sessions, folder, wanted);
    study.runs = makeRuns(study.sessions.size(), variants.runs);
    study.parameters = std::move(variants.parameters);
    study.warnings = unknownKeys(top);
    requireModels(study);
    return study;
}

Study readStudyFile(const fs::path& file, std::optional<std::size_t> onlyRun) {
    const std::string text = readInputFile(file, kMaxStudyBytes);
    const std::string name = file.filename().string();
    try {
        Study study = parseStudy(text, fs::absolute(file).parent_path(), onlyRun);
        study.name = name.substr(0, name.find('.'));
        for (std::string& warning : study.warnings) {
            warning.insert(0, name + ": ");
        }
        return study;
    } catch (const InputError& error) {
        throw InputError(name + ": " + error.what());
    }
}

}  // namespace

Study readStudy(const fs::path& file) {
    return readStudyFile(file, std::nullopt);
}

Study readStudyForRun(const fs::path& file, std::size_t number) {
    return readStudyFile(file, number);
}

std::string valueText(const ParamValue& value) {
    // "-0" would be read back as the integer 0: -0 and 0 are one.
    const auto text = [](double x) { return formatNumber(x + 0.0); };
    if (const auto* number = std::get_if<double>(&value)) {
        return text(*number);
    }
    if (const auto* vector = std::get_if<Vec3>(&value)) {
        return "[" + joined(*vector, ", ", text) + "]";
    }
    const auto* word = std::get_if<std::string>(&value);
    return word != nullptr ? "\"" + *word + "\"" : "null";
}

std::string startValue(const Study& study, const StudyRun& run, const std::string& parameter) {
    const auto set = std::ranges::find(run.settings, parameter, &Setting::name);
    return set != run.settings.end() ? set->value
                                     : valueText(getParam(study.sessionOf(run).params, parameter));
}

std::string settingsText(const StudyRun& run) {
    return joined(run.settings, " ",
                  [](const Setting& setting) { return setting.name + "=" + setting.value; });
}

}  // namespace kerf::app
