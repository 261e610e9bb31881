#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/option_checks.h"
#include "app/cli/verb.h"
#include "app/doctor/doctor.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDoctorReportFile = "report.md";
constexpr const char* kJsonFile = "doctor.json";
constexpr const char* kPictureFile = "cut.png";

/// The arguments of `kerf doctor [--quick] [--out DIR] [--json]`, parsed.
struct DoctorArguments {
    bool quick = false;         ///< leaves the speeds out
    std::filesystem::path out;  ///< folder of the report; empty for none
    bool json = false;
};

Json toJson(const Diagnosis& diagnosis) {
    Json findings = Json::array();
    for (const DriverFinding& finding : diagnosis.findings) {
        findings.push_back({{"check", finding.check},
                            {"seen", finding.seen},
                            {"asked", finding.asked},
                            {"right", finding.right}});
    }
    Json limits = Json::object();
    for (const gpu::DriverLimit& limit : diagnosis.limits) {
        limits[limit.name] = {{"has", limit.has}, {"needs", limit.needs}};
    }
    Json speeds = Json::array();
    for (const ModelSpeed& speed : diagnosis.speeds) {
        speeds.push_back({{"model", speed.model},
                          {"frames", speed.frames},
                          {"fps", speed.framesPerSecond()},
                          {"worst_cut_ms", speed.worstCutMs},
                          {"real_time_factor", toJson(speed.realTime)}});
    }
    return {{"kerf", KERF_VERSION},
            {"vendor", diagnosis.device.vendor},
            {"renderer", diagnosis.device.renderer},
            {"driver", diagnosis.device.version},
            {"right", diagnosis.right()},
            {"verdict", diagnosis.verdict()},
            {"opengl_errors", diagnosis.debugErrors},
            {"seconds", diagnosis.seconds},
            {"limits", std::move(limits)},
            {"findings", std::move(findings)},
            {"speeds", std::move(speeds)}};
}

std::string driverLines(const Diagnosis& diagnosis) {
    return fmt::format("Kerf {} on {} ({}), OpenGL {}", KERF_VERSION, diagnosis.device.renderer,
                       diagnosis.device.vendor, diagnosis.device.version);
}

std::string speedPhrase(const ModelSpeed& speed) {
    if (speed.frames == 0) {
        return "too slow to be timed";
    }
    const std::string worst =
        speed.worstCutMs > 0
            ? fmt::format(", worst frame while cutting {:.0f} ms", speed.worstCutMs)
            : "";
    const auto factor = speed.realTime.median();
    const std::string alone =
        factor ? fmt::format(", {} real time without pictures", factorText(*factor)) : "";
    return fmt::format("{:.1f} frames a second{}{}", speed.framesPerSecond(), worst, alone);
}

std::string markdownOf(const Diagnosis& diagnosis) {
    std::string text = fmt::format("# Kerf on this machine\n\n{}.\n\n{}\n\n",
                                   driverLines(diagnosis), diagnosis.verdict());
    if (!diagnosis.picture.pixels.empty()) {
        text += fmt::format("![A cut as this driver draws it]({})\n\n", kPictureFile);
    }
    if (!diagnosis.speeds.empty()) {
        text += "| model | speed, 1280x720 |\n|---|---|\n";
        for (const ModelSpeed& speed : diagnosis.speeds) {
            text += fmt::format("| {} | {} |\n", speed.model, speedPhrase(speed));
        }
        text += "\n";
    }
    text += "| check | seen | asked | |\n|---|---|---|---|\n";
    for (const DriverFinding& finding : diagnosis.findings) {
        text += fmt::format("| {} | {} | {} | {} |\n", finding.check, finding.seen, finding.asked,
                            finding.right ? "right" : "**wrong**");
    }
    text += fmt::format("\nOpenGL told of {} errors. All took {:.0f} s.\n", diagnosis.debugErrors,
                        diagnosis.seconds);
    return text;
}

/// What is wrong line by line, and how much is right.
void print(const Diagnosis& diagnosis, std::ostream& out) {
    out << driverLines(diagnosis) << "\n";
    for (const DriverFinding& finding : diagnosis.findings) {
        if (!finding.right) {
            out << fmt::format("WRONG  {}: {}, asked {}\n", finding.check, finding.seen,
                               finding.asked);
        }
    }
    const auto right = std::ranges::count_if(diagnosis.findings, &DriverFinding::right);
    out << fmt::format("{} of {} checks are right\n", right, diagnosis.findings.size());
    for (const ModelSpeed& speed : diagnosis.speeds) {
        out << fmt::format("{:10} {}\n", speed.model, speedPhrase(speed));
    }
    out << diagnosis.verdict() << "\n";
}

void writeReport(const Diagnosis& diagnosis, OutputFolder& folder) {
    if (!diagnosis.picture.pixels.empty()) {
        writePicture(diagnosis.picture, folder.pathOf(kPictureFile));
        folder.noteWritten(kPictureFile);
    }
    folder.write(kJsonFile, toJson(diagnosis).dump(2, ' ', false, Json::error_handler_t::replace));
    folder.write(kDoctorReportFile, markdownOf(diagnosis));
}

int runDoctor(const DoctorArguments& arguments, std::ostream& out, std::ostream& errors) {
    refuseFileAsFolder(arguments.out);
    std::optional<OutputFolder> folder;
    if (!arguments.out.empty()) {
        folder.emplace(arguments.out);
    }
    gpu::EglContext context;
    gpu::enableDebugOutput();
    Examination examination;
    examination.speeds = !arguments.quick;
    examination.next = [&errors](const std::string& part) { errors << "  " << part << "\n"; };
    const Diagnosis diagnosis = diagnose(examination);
    if (folder) {
        writeReport(diagnosis, *folder);
    }
    if (arguments.json) {
        out << toJson(diagnosis).dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
    } else {
        print(diagnosis, out);
    }
    return diagnosis.right() ? kExitDone : kExitCheckFailed;
}

std::function<int()> describeDoctor(CLI::App& verb) {
    const auto arguments = std::make_shared<DoctorArguments>();
    verb.add_flag("--quick", arguments->quick, "Skip the speed of the models");
    addOut(verb, arguments->out, "Folder for a report with a picture, to attach to a bug");
    verb.add_flag("--json", arguments->json, "Print one JSON object");
    return [arguments] { return runDoctor(*arguments, std::cout, std::cerr); };
}

}  // namespace

const Verb kDoctorVerb{"doctor",
                       "Check whether Kerf works correctly with this machine's graphics driver",
                       describeDoctor};

}  // namespace kerf::app
