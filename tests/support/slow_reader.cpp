#include "tests/support/slow_reader.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace kerf::test {
namespace {

constexpr char kVariable[] = "KERF_EXECUTABLE";

}  // namespace

SlowReader::SlowReader(const std::filesystem::path& folder) : pidFile_(folder / "slow-reader.pid") {
    const std::filesystem::path program = folder / "slow-reader.sh";
    std::ofstream(program) << "#!/bin/sh\necho $$ > '" << pidFile_.string()
                           << "'\nexec sleep 100\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    if (const char* old = std::getenv(kVariable)) {
        before_ = old;
    }
    setenv(kVariable, program.c_str(), 1);
}

SlowReader::~SlowReader() {
    if (before_.empty()) {
        unsetenv(kVariable);
    } else {
        setenv(kVariable, before_.c_str(), 1);
    }
}

pid_t SlowReader::process() const {
    pid_t pid = 0;
    std::ifstream(pidFile_) >> pid;
    return pid;
}

bool SlowReader::hasEnded() const {
    const pid_t pid = process();
    for (int i = 0; i < 2000; ++i) {
        if (pid > 0 && ::kill(pid, 0) != 0) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

}  // namespace kerf::test
