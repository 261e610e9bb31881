#include "app/regression/test_report.h"

#include <spdlog/fmt/chrono.h>

#include <ctime>
#include <nlohmann/json.hpp>

#include "app/files/io/base64.h"
#include "app/files/io/data_page.h"
#include "app/files/io/file_io.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMaxEmbeddedBytes = 256u << 20;
constexpr std::size_t kPlottedSteps = 400;

/// The picture as the address of an image; null where there is none.
Json imageAddress(const fs::path& file) {
    if (file.empty() || !fs::exists(file)) {
        return nullptr;
    }
    return "data:image/png;base64," + base64(readInputFile(file, kMaxEmbeddedBytes));
}

Json pageData(const PictureCheck& picture, const TestResult& result) {
    return {{"file", picture.file},
            {"alike", picture.alike},
            {"expected", imageAddress(expectationFolder(result.session) / picture.file)},
            {"actual", imageAddress(result.results / picture.file)},
            {"difference", imageAddress(picture.difference)}};
}

/// Some values of a run, evenly spaced over its steps: {"x": [...], "y": [...]}.
template <class Value>
Json curve(const RunTrace& trace, Value value) {
    Json x = Json::array();
    Json y = Json::array();
    const std::size_t spacing = trace.size() / kPlottedSteps + 1;
    for (std::size_t step = 0; step < trace.size(); step += spacing) {
        x.push_back(step);
        y.push_back(value(trace[step]));
    }
    return {{"x", std::move(x)}, {"y", std::move(y)}};
}

/// What a plot is called, and how its axis reads.
struct PlotScale {
    const char* title;
    double least = 0;    ///< span of the axis at least, in the unit of the title
    bool whole = false;  ///< what is counted
};

template <class Value>
Json plot(const PlotScale& scale, const Judgement& judgement, Value value) {
    return {{"title", scale.title},
            {"least", scale.least},
            {"whole", scale.whole},
            {"expected", curve(judgement.expectedTrace, value)},
            {"actual", curve(judgement.trace, value)}};
}

Json positionPlot(const Judgement& judgement) {
    Json x = Json::array();
    Json y = Json::array();
    for (const Deviation& deviation : judgement.positions) {
        x.push_back(deviation.step);
        y.push_back(1000 * deviation.value);
    }
    return {{"title", "Farthest side of a piece's box, mm off"},
            {"least", 0.01},
            {"whole", false},
            {"actual", {{"x", std::move(x)}, {"y", std::move(y)}}}};
}

Json plots(const Judgement& judgement) {
    if (judgement.expectedTrace.empty()) {
        return Json::array();
    }
    const double start = judgement.expectedTrace.front().volume;
    return Json::array(
        {positionPlot(judgement),
         plot({"Volume, % of the first step", 0.1}, judgement,
              [start](const TraceRow& row) { return 100 * row.volume / start; }),
         plot({"Pieces", 2, true}, judgement, [](const TraceRow& row) { return row.pieces; }),
         plot({"Triangles", 10, true}, judgement,
              [](const TraceRow& row) { return row.triangles; })});
}

std::string nameOf(const Driver& driver) {
    return driver.renderer.empty() ? "" : driver.renderer + ", OpenGL " + driver.version;
}

Json pageData(const TestResult& result) {
    Json findings = Json::array();
    for (const Finding& finding : result.judgement.findings) {
        findings.push_back(finding.sentence);
    }
    Json pictures = Json::array();
    for (const PictureCheck& picture : result.judgement.pictures) {
        pictures.push_back(pageData(picture, result));
    }
    return {{"name", result.name},
            {"status", nameOf(result.status)},
            {"failed", result.failed()},
            {"seconds", result.seconds},
            {"other_driver", result.judgement.otherDriver},
            {"driver", nameOf(result.driver)},
            {"made_with", nameOf(result.judgement.expectedDriver)},
            {"findings", std::move(findings)},
            {"notes", result.notes},
            {"pictures", std::move(pictures)},
            {"plots", plots(result.judgement)}};
}

/// "2026-03-09 14:05 UTC".
std::string timeOfDay() {
    return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
}

}  // namespace

std::string formatTestReport(const std::vector<TestResult>& results) {
    Json tests = Json::array();
    for (const TestResult& result : results) {
        tests.push_back(pageData(result));
    }
    return dataPage("test-report.html",
                    {{"kerf", KERF_VERSION}, {"time", timeOfDay()}, {"tests", std::move(tests)}});
}

}  // namespace kerf::app
