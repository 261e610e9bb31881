#include "app/study/run_record.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/files/io/encodings.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/session/session.h"
#include "app/session/session_json.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMaxRecordBytes = 1u << 20;
constexpr const char* kRunFormat = "kerf-sweep-run";
constexpr std::uint64_t kMostExitCode = 255;
constexpr int kLastOfReplay = 3;  // docs/cli.md: beyond it stand limits of the machine

Json toJson(const std::vector<Setting>& settings) {
    Json json = Json::object();
    for (const Setting& setting : settings) {
        json[setting.name] = Json::parse(setting.value);
    }
    return json;
}

/// An exit code; of other numbers nobody knows what they would mean.
int exitCodeIn(const Json& json) {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() > kMostExitCode) {
        throw InputError(std::string(kRecordFile) + ": this is no exit code.");
    }
    return json.get<int>();
}

RunRecord toRecord(const Json& json) {
    if (json.at("format") != kRunFormat || json.at("version") != 1) {
        throw InputError(std::string(kRecordFile) + ": this is some other file.");
    }
    RunRecord record;
    json.at("program").get_to(record.identity.program);
    json.at("session_sha256").get_to(record.identity.session);
    json.at("model_sha256").get_to(record.identity.model);
    for (const auto& item : json.at("params").items()) {
        record.identity.settings.push_back({item.key(), item.value().dump()});
    }
    record.exitCode = exitCodeIn(json.at("exit"));
    json.at("problem").get_to(record.problem);
    record.results = json.value("results", ResultDigests());
    return record;
}

/// The parts in which two runs are not the same.
std::vector<std::string> changedParts(const RunIdentity& before, const RunIdentity& now) {
    std::vector<std::string> parts;
    if (toJson(before.settings) != toJson(now.settings)) parts.emplace_back("its parameters");
    if (before.session != now.session) parts.emplace_back("its session");
    if (before.model != now.model) parts.emplace_back("its model");
    if (before.program != now.program) parts.emplace_back("the version of Kerf");
    return parts;
}

std::string digestOf(const fs::path& file) {
    try {
        return sha256OfFile(file);
    } catch (const std::runtime_error&) {  // it is missing, or can't be read
        return "";
    }
}

/// The file that is not as the run left it, record included; "" where all are.
fs::path damagedFile(const fs::path& folder, const std::optional<RunRecord>& record) {
    std::error_code error;
    if (!record) {
        return fs::exists(folder / kRecordFile, error) ? folder / kRecordFile : fs::path();
    }
    const ResultDigests now = digestsOf(folder);
    const auto other = std::ranges::mismatch(now, record->results).in1;
    return other == now.end() ? fs::path() : folder / other->first;
}

}  // namespace

RunIdentity identityOf(const Study& study, const StudyRun& run) {
    const StudySession& session = study.sessionOf(run);
    return {KERF_VERSION, session.sha256, session.modelSha256, run.settings};
}

fs::path folderOfRun(const fs::path& out, std::size_t number) {
    return out / std::to_string(number);
}

ResultDigests digestsOf(const fs::path& folder) {
    ResultDigests digests;
    for (const char* name : {kSummaryFile, kMetricsFile}) {
        digests[name] = digestOf(folder / name);
    }
    return digests;
}

std::string formatRecord(const RunRecord& record) {
    Json json;
    json["format"] = kRunFormat;
    json["version"] = 1;
    json["program"] = record.identity.program;
    json["session_sha256"] = record.identity.session;
    json["model_sha256"] = record.identity.model;
    json["params"] = toJson(record.identity.settings);
    json["exit"] = record.exitCode;
    json["problem"] = record.problem;
    json["results"] = record.results;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<RunRecord> readRecord(const fs::path& folder) {
    try {
        return toRecord(parseOrderedJson(readInputFile(folder / kRecordFile, kMaxRecordBytes)));
    } catch (const InputError&) {
        return std::nullopt;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

RunState stateOfRun(const Study& study, std::size_t number, const fs::path& out) {
    const fs::path folder = folderOfRun(out, number);
    std::optional<RunRecord> record = readRecord(folder);
    if (const fs::path damaged = damagedFile(folder, record); !damaged.empty()) {
        return {std::nullopt, damaged.string() + " is damaged"};
    }
    if (!record) {
        return {};
    }
    const auto changed = changedParts(record->identity, identityOf(study, study.runs[number]));
    if (!changed.empty()) {
        return {std::nullopt, enumerated(changed) + " changed"};
    }
    std::string reason = record->exitCode > kLastOfReplay ? record->problem : "";
    reason.erase(reason.find_last_not_of('.') + 1);
    return {std::move(record), std::move(reason)};
}

}  // namespace kerf::app
