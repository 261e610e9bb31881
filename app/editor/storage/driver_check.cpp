#include "app/editor/storage/driver_check.h"

#include <spdlog/spdlog.h>

#include <cctype>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/files/io/file_io.h"
#include "app/files/jobs/child_runs.h"
#include "gpu/data_path.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostReportBytes = 1u << 20;
constexpr std::size_t kMostLetters = 120;  // of a folder's name

fs::path reportFile(const fs::path& folder) {
    return folder / "doctor.json";
}

/// Letters and digits of a text, with a dash for what lies between.
std::string nameFor(const std::string& text) {
    std::string name;
    for (const char c : text) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (plain || (!name.empty() && name.back() != '-')) {
            name += plain ? c : '-';
        }
    }
    return beginningOf(name, kMostLetters);
}

/// The verdict of a report; "" where there is none.
std::string verdictIn(const fs::path& folder) {
    try {
        const auto report =
            nlohmann::json::parse(readInputFile(reportFile(folder), kMostReportBytes));
        return report.at("verdict").get<std::string>();
    } catch (const std::exception& error) {
        spdlog::warn("{}", error.what());
        return "";
    }
}

std::optional<DriverProblem> examine(const fs::path& folder, const WorkProgress& progress) {
    fs::create_directories(folder);
    const ChildOutcome end =
        runChild({"doctor", "--quick", "--out", folder.string()}, progress, [](int) {});
    if (end.exitCode == 0) {
        return std::nullopt;
    }
    const std::string verdict = verdictIn(folder);
    if (!verdict.empty()) {
        return DriverProblem{verdict, folder};
    }
    return DriverProblem{
        "The check of this graphics driver did not finish (" + sentenceAbout(end) + ").", {}};
}

}  // namespace

DriverCheck::DriverCheck(const fs::path& folder, const std::string& driver) {
    if (folder.empty()) {
        return;
    }
    const fs::path own = folder / nameFor(driver + " kerf " KERF_VERSION);
    std::error_code error;
    if (!fs::exists(reportFile(own), error) && !error) {
        looking_ = std::make_unique<Looking>(
            [own](const WorkProgress& progress) { return examine(own, progress); });
    }
}

std::optional<DriverProblem> DriverCheck::takeProblem() {
    if (looking_ == nullptr || !looking_->done()) {
        return std::nullopt;
    }
    const std::unique_ptr<Looking> done = std::move(looking_);
    try {
        return done->take();
    } catch (const std::exception& error) {
        spdlog::warn("The graphics driver could not be checked: {}", error.what());
        return std::nullopt;
    }
}

ui::Question questionAbout(const DriverProblem& problem) {
    const std::string where =
        problem.report.empty() ? "" : " The report is in " + problem.report.string() + ".";
    return {"This graphics driver may give wrong results",
            problem.sentence + where,
            {"Use software renderer", "Keep this driver"},
            {}};
}

fs::path defaultDriverReports() {
    const char* const examines = std::getenv("KERF_EXAMINES_DRIVER");
    const bool wanted = examines == nullptr || std::string_view(examines) != "no";
    return wanted ? gpu::statePath("drivers") : fs::path();
}

void useSoftwareRenderer() {
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    ::setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    ::setenv("__GLX_VENDOR_LIBRARY_NAME", "mesa", 1);  // beside a driver that is not Mesa's
    ::unsetenv("MESA_LOADER_DRIVER_OVERRIDE");
}

}  // namespace kerf::app
