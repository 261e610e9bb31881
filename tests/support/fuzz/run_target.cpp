#include "app/files/io/errors.h"
#include "app/session/session.h"
#include "app/study/study_table.h"
#include "tests/support/fuzz/packed_files.h"
#include "tests/support/fuzz/refusal.h"
#include "tests/support/fuzz/targets.h"
#include "tests/support/fuzz/text_mutator.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace {

/// The folder of a study's results.
const TemporaryFolder& out() {
    static const TemporaryFolder folder;
    return folder;
}

/// One run, of which it does not matter what it sets.
const app::Study& study() {
    static const app::Study one = [] {
        app::Study study;
        study.name = "study";
        study.sessions.push_back({"a.kerf.json", "/a.kerf.json", "00", "11", {}});
        study.parameters = {"time_step"};
        study.runs.push_back({0, {{"time_step", "0.003"}}});
        return study;
    }();
    return one;
}

std::string brokenByWriting(const app::RunRecord& record, const std::filesystem::path& folder) {
    const std::string text = app::formatRecord(record);
    writeText(folder / app::kRecordFile, text);
    const auto again = app::readRecord(folder);
    return again && app::formatRecord(*again) == text ? "" : "It reads back otherwise: " + text;
}

/// Commas outside of quotes end a cell, line breaks a row.
std::string brokenTable(const std::string& table) {
    bool quoted = false;
    std::vector<int> cells{1};
    for (const char c : table) {
        quoted = quoted != (c == '"');
        cells.back() += c == ',' && !quoted ? 1 : 0;
        if (c == '\n' && !quoted) {
            cells.push_back(1);
        }
    }
    const bool right = cells.size() == 3 && cells[0] == cells[1] && !quoted;
    return right ? "" : "The table is none: " + table;
}

}  // namespace

FuzzOutcome readRunText(const std::string& text) {
    const std::filesystem::path folder = app::folderOfRun(out().path(), 0);
    std::filesystem::create_directories(folder);
    unpack(text, folder, {app::kRecordFile, app::kSummaryFile, app::kMetricsFile});
    app::stateOfRun(study(), 0, out().path());
    std::optional<app::RunRecord> record = app::readRecord(folder);
    if (!record) {
        return {};
    }
    if (std::string broken = brokenByWriting(*record, folder); !broken.empty()) {
        return {true, std::move(broken)};
    }
    // As if the run had left these files, so that they are looked at.
    record->identity = app::identityOf(study(), study().runs[0]);
    record->results = app::digestsOf(folder);
    writeText(folder / app::kRecordFile, app::formatRecord(*record));
    try {
        return {true, brokenTable(app::gatherTable(study(), out().path()).text)};
    } catch (const app::InputError& error) {
        return refusedWith(error.what());
    }
}

std::vector<std::string> runTexts() {
    const std::string record =
        app::formatRecord({app::identityOf(study(), study().runs[0]), 0, "", {}});
    const std::string failed = app::formatRecord(
        {app::identityOf(study(), study().runs[0]), 137, "It was ended by a signal.", {}});
    const std::string summary =
        R"({"renderer": "llvmpipe", "driver": "4.5", "steps": 2, "state_hash": "00112233aabbccdd",
            "pieces": [{"triangles": 20, "volume": 0.5}], "volume_ratio": {"mean": 1, "min": 0.99,
            "final": 1}, "fps": {"mean": 61.5, "min": 60, "max": null}})";
    const std::string metrics = "step,time,volume,pieces\n0,0.005,0.25,1\n1,0.01,0.25,2\n";
    return {packed({record, summary, metrics}), packed({failed, summary}), packed({record})};
}

std::vector<std::string> runWords() {
    return jsonWordsOf(runTexts());
}

}  // namespace kerf::test
