#include "app/regression/test_result.h"

#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>

#include <ctime>
#include <nlohmann/json.hpp>

#include "app/files/io/data_page.h"
#include "app/files/io/encodings.h"
#include "app/files/io/file_io.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 7> kStatusNames = {
    "passed", "failed", "unreadable", "unwritable", "made", "renewed", "not run"};

/// The element of JUnit XML that says why a test is no success; "" for one that is.
std::string_view junitElement(const TestResult& result) {
    if (result.status == TestStatus::notRun) {
        return "skipped";
    }
    return !result.failed() ? "" : result.status == TestStatus::failed ? "failure" : "error";
}

/// All findings in one line; "" where there are none.
std::string findingsOf(const TestResult& result) {
    return joined(result.judgement.findings, " ", &Finding::sentence);
}

std::string testCase(const TestResult& result) {
    const std::string head =
        fmt::format(R"(    <testcase classname="kerf" name="{}" time="{:.3f}")",
                    xmlText(result.name), result.seconds);
    const std::string_view element = junitElement(result);
    if (element.empty()) {
        return head + "/>\n";
    }
    return head + fmt::format(">\n      <{0} message=\"{1}\"/>\n    </testcase>\n", element,
                              xmlText(findingsOf(result)));
}

Json toJson(const TestResult& result) {
    Json findings = Json::array();
    for (const Finding& finding : result.judgement.findings) {
        findings.push_back({{"part", finding.part},
                            {"step", finding.step < 0 ? Json() : Json(finding.step)},
                            {"file", finding.file.empty() ? Json() : Json(finding.file)},
                            {"sentence", finding.sentence}});
    }
    return {{"name", result.name},
            {"status", nameOf(result.status)},
            {"seconds", result.seconds},
            {"other_driver", result.judgement.otherDriver},
            {"findings", std::move(findings)},
            {"notes", result.notes}};
}

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

std::string_view nameOf(TestStatus status) {
    return kStatusNames[static_cast<std::size_t>(status)];
}

std::string formatJUnit(const std::vector<TestResult>& results) {
    const auto countOf = [&](std::string_view element) {
        return std::ranges::count(results, element, junitElement);
    };
    double seconds = 0;
    std::string cases;
    for (const TestResult& result : results) {
        seconds += result.seconds;
        cases += testCase(result);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
        "  <testsuite name=\"kerf\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" "
        "time=\"{:.3f}\">\n{}  </testsuite>\n</testsuites>\n",
        results.size(), countOf("failure"), countOf("error"), countOf("skipped"), seconds, cases);
}

std::string formatJson(const std::vector<TestResult>& results) {
    Json tests = Json::array();
    for (const TestResult& result : results) {
        tests.push_back(toJson(result));
    }
    const auto failed = std::ranges::count_if(results, &TestResult::failed);
    const auto notRun = std::ranges::count(results, TestStatus::notRun, &TestResult::status);
    const Json json = {{"tests", std::move(tests)},
                       {"passed", std::ssize(results) - failed - notRun},
                       {"failed", failed},
                       {"not_run", notRun},
                       {"stopped", notRun > 0}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string formatTestReport(const std::vector<TestResult>& results) {
    Json tests = Json::array();
    for (const TestResult& result : results) {
        tests.push_back(pageData(result));
    }
    return dataPage("test-report.html",
                    {{"kerf", KERF_VERSION}, {"time", timeOfDay()}, {"tests", std::move(tests)}});
}

}  // namespace kerf::app
