#pragma once

#include "app/regression/judgement.h"

namespace kerf::app {

/// The status of a regression test.
enum class TestStatus {
    passed,
    failed,      ///< it differs, or has no expectation
    unreadable,  ///< session, model or expectation can't be read
    unwritable,  ///< something can't be written, such as its new expectation
    made,        ///< its expectation was written for the first time
    renewed,     ///< its expectation was renewed
    notRun,      ///< the tests were stopped before its turn
};

/// A session that was run as a regression test.
struct TestResult {
    std::string name;  ///< path of the session without its ending
    std::filesystem::path session;
    TestStatus status = TestStatus::failed;
    double seconds = 0;             ///< of the run, wall clock
    Judgement judgement;            ///< its findings say why it failed, or what was renewed
    std::filesystem::path results;  ///< folder of the run
    Driver driver;                  ///< of the run; empty for none
    /// Sentences for the owner, for which no test fails.
    std::vector<std::string> notes;

    bool failed() const {
        return status == TestStatus::failed || status == TestStatus::unreadable ||
               status == TestStatus::unwritable;
    }
};

/// "passed", "failed", ...
std::string_view nameOf(TestStatus status);

/// The results as JUnit XML, which CI servers show.
std::string formatJUnit(const std::vector<TestResult>& results);
/// The results as one JSON object with its line break.
std::string formatJson(const std::vector<TestResult>& results);

/// The results as a self-contained HTML page: each picture expected, actual, and the difference,
/// with a slider between them, and plots of deviations. Throws InputError if the page's template or
/// a picture can't be read.
std::string formatTestReport(const std::vector<TestResult>& results);

}  // namespace kerf::app
