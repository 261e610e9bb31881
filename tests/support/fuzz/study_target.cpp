#include <nlohmann/json.hpp>

#include "app/files/io/errors.h"
#include "app/study/study.h"
#include "tests/support/fuzz/refusal.h"
#include "tests/support/fuzz/targets.h"
#include "tests/support/fuzz/text_mutator.h"
#include "tests/support/small_sessions.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostWrittenAgain = 200;  // runs: it takes its time

/// A folder with the sessions that the texts name.
const TemporaryFolder& studyFolder() {
    static const auto filled = [] {
        auto made = std::make_unique<TemporaryFolder>();
        writeText(*made / "a.kerf.json", sessionThatDoes(""));
        writeText(*made / "b.kerf.json", sessionThatDoes(R"({"step": 3, "type": "lift"})"));
        return made;
    }();
    return *filled;
}

app::Study studyOf(const std::string& text) {
    writeText(studyFolder() / "study.json", text);
    return app::readStudy(studyFolder() / "study.json");
}

/// The study with its runs one by one.
std::string textOf(const app::Study& study) {
    Json json{{"format", "kerf-sweep"}, {"version", 1}};
    for (const app::StudySession& session : study.sessions) {
        json["sessions"].push_back(session.name);
    }
    for (const app::StudyRun& run : study.runs) {
        Json settings = Json::object();
        for (const app::Setting& setting : run.settings) {
            settings[setting.name] = Json::parse(setting.value);
        }
        if (run.session == 0) {
            json["runs"].push_back(std::move(settings));
        }
    }
    return json.dump();
}

std::string settingsOf(const app::Study& study) {
    std::string text;
    for (const app::StudyRun& run : study.runs) {
        text += std::to_string(run.session) + " " + app::settingsText(run) + "\n";
    }
    return text;
}

std::string brokenBy(const app::Study& study) {
    if (study.runs.empty() || study.runs.size() > app::kMostRuns) {
        return "It has " + std::to_string(study.runs.size()) + " runs.";
    }
    if (study.runs.size() > kMostWrittenAgain) {
        return "";
    }
    const std::string text = textOf(study);
    if (settingsOf(studyOf(text)) != settingsOf(study)) {
        return "It reads back as another study: " + text;
    }
    const app::Study ofOne =
        app::readStudyForRun(studyFolder() / "study.json", study.runs.size() - 1);
    return settingsOf(ofOne) == settingsOf(study) ? "" : "Read for one run it is another: " + text;
}

}  // namespace

FuzzOutcome readStudyText(const std::string& text) {
    app::Study study;
    try {
        study = studyOf(text);
    } catch (const app::InputError& error) {
        return refusedWith(error.what());
    }
    return {true, brokenBy(study)};
}

std::vector<std::string> studyTexts() {
    const std::string head = R"({"format": "kerf-sweep", "version": 1, "sessions": )";
    return {
        head + R"(["a.kerf.json"], "grid": {"time_step": [0.003, 0.005], "ispc_stiffness": [0.1,
            0.5, 1], "gravity": [[0, -9.81, 0]], "floor": [null, -1], "solver": ["pbd"]}})",
        head + R"(["a.kerf.json", "b.kerf.json"], "runs": [{}, {"iterations": 3, "floor": -2.5},
            {"friction": 0.25, "time_step": 0.002}], "note": "unknown"})",
    };
}

std::vector<std::string> studyWords() {
    std::vector<std::string> words = jsonWordsOf(studyTexts());
    for (const ParamInfo& info : paramTable()) {
        words.push_back("\"" + std::string(info.name) + "\": [");
    }
    return words;
}

}  // namespace kerf::test
