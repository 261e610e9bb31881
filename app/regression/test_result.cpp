#include "app/regression/test_result.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "sim/base/text.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 5> kStatusNames = {"passed", "failed", "unreadable", "made",
                                                          "renewed"};

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

std::string testCase(const TestResult& result) {
    const std::string head =
        fmt::format(R"(    <testcase classname="kerf" name="{}" time="{:.3f}")",
                    escaped(result.name), result.seconds);
    if (!result.failed()) {
        return head + "/>\n";
    }
    const char* kind = result.status == TestStatus::unreadable ? "error" : "failure";
    return head + fmt::format(">\n      <{0} message=\"{1}\"/>\n    </testcase>\n", kind,
                              escaped(findingsOf(result)));
}

Json toJson(const TestResult& result) {
    Json findings = Json::array();
    for (const Finding& finding : result.judgement.findings) {
        findings.push_back({{"part", finding.part},
                            {"step", finding.step < 0 ? Json() : Json(finding.step)},
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

std::string findingsOf(const TestResult& result) {
    return joined(result.judgement.findings, " ", &Finding::sentence);
}

std::string formatJUnit(const std::vector<TestResult>& results) {
    const auto countOf = [&](TestStatus status) {
        return std::ranges::count(results, status, &TestResult::status);
    };
    double seconds = 0;
    std::string cases;
    for (const TestResult& result : results) {
        seconds += result.seconds;
        cases += testCase(result);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
        "  <testsuite name=\"kerf\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n"
        "{}  </testsuite>\n</testsuites>\n",
        results.size(), countOf(TestStatus::failed), countOf(TestStatus::unreadable), seconds,
        cases);
}

std::string formatJson(const std::vector<TestResult>& results) {
    Json tests = Json::array();
    for (const TestResult& result : results) {
        tests.push_back(toJson(result));
    }
    const auto failed = std::ranges::count_if(results, &TestResult::failed);
    const Json json = {{"tests", std::move(tests)},
                       {"passed", results.size() - static_cast<std::size_t>(failed)},
                       {"failed", failed}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace kerf::app
