#include "app/cli/replay_verb.h"

#include <spdlog/spdlog.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/exit_codes.h"
#include "app/cli/replay.h"
#include "app/files/progress_line.h"
#include "gpu/context.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

ReplayResult runHeadless(const Session& session, ModelMesh model,
                         const std::filesystem::path& folder) {
    gpu::EglContext context;
    gpu::enableDebugOutput();
    ProgressLine line;
    return replaySession(session, std::move(model), folder,
                         {[&line](int done, int total) { line.show(done, total); }, {}});
}

std::string percent(double ratio) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f %%", 100 * ratio);
    return text;
}

void printForPeople(const ReplayResult& result, const std::filesystem::path& folder,
                    std::ostream& out) {
    const RunSummary& summary = result.summary;
    const RunStatistics& run = summary.statistics;
    out << summary.model << ": " << run.steps << " steps, "
        << counted(summary.pieces.size(), "piece", "pieces") << ", " << summary.before.triangles
        << " triangles before and " << summary.after.triangles << " after\n";
    out << "volume: mean " << percent(run.volumeRatio.mean()) << ", min "
        << percent(run.volumeRatio.min()) << ", final " << percent(run.finalVolumeRatio)
        << " of rest\n";
    out << "state: " << summary.stateHash << "\n";
    out << "written to " << folder.string() << ":";
    for (const std::string& file : result.files) {
        out << " " << file;
    }
    out << "\n";
}

void printJson(const ReplayResult& result, std::ostream& out) {
    nlohmann::ordered_json json = toJson(result.summary);
    json["files"] = result.files;
    out << json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
}

}  // namespace

int replayVerb(const ReplayArguments& arguments, std::ostream& out, std::ostream& errors) {
    const Session session = readSession(arguments.session);
    for (const std::string& warning : session.warnings) {
        spdlog::warn(warning);
    }
    const ReplayResult result = runHeadless(session, loadSessionModel(session), arguments.out);
    if (arguments.json) {
        printJson(result, out);
    } else {
        printForPeople(result, arguments.out, out);
    }
    const auto& failures = result.summary.failures;
    if (failures.empty()) {
        return kExitDone;
    }
    errors << failures.front();
    if (failures.size() > 1) {
        errors << " (" << failures.size() - 1 << " more in summary.json.)";
    }
    errors << "\n";
    return kExitCheckFailed;
}

}  // namespace kerf::app
