#pragma once

#include "tests/support/run_kerf.h"
#include "tests/support/small_sessions.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {

/// A small session in a folder of its own, which `kerf replay` plays into its folder "out".
class SmallSessionTest : public testing::Test {
  protected:
    SmallSessionTest() { test::writeText(folder_ / "test.kerf.json", test::smallSession()); }

    test::ProgramRun replay(const std::vector<std::string>& options,
                            const std::map<std::string, std::string>& environment = {}) const {
        std::vector<std::string> words{"replay", path("test.kerf.json"), "--out", path("out")};
        words.insert(words.end(), options.begin(), options.end());
        return test::runKerf(words, environment);
    }
    std::string path(const std::string& name) const { return folder_ / name; }

    test::TemporaryFolder folder_;
};

}  // namespace kerf::app
