#include "app/regression/test_result.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>

#include "sim/base/text.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 7> kStatusNames = {
    "passed", "failed", "unreadable", "unwritable", "made", "renewed", "not run"};

/// The text as UTF-8 that XML can hold: U+FFFD stands for what names of files may have besides.
std::string asUtf8(const std::string& text) {
    std::string valid =
        Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
    for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
        for (std::size_t at = 0; (at = valid.find(none, at)) != std::string::npos;) {
            valid.replace(at, none.size(), "\xEF\xBF\xBD");
        }
    }
    return valid;
}

/// Text as XML holds it. Control characters have no place there.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : asUtf8(text)) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

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
                    escaped(result.name), result.seconds);
    const std::string_view element = junitElement(result);
    if (element.empty()) {
        return head + "/>\n";
    }
    return head + fmt::format(">\n      <{0} message=\"{1}\"/>\n    </testcase>\n", element,
                              escaped(findingsOf(result)));
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

}  // namespace kerf::app
