#include "tests/support/run_kerf.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include "tests/paths.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace {

void redirect(int descriptor, const std::string& file, int flags) {
    const int opened = ::open(file.c_str(), flags, 0600);
    if (opened < 0 || ::dup2(opened, descriptor) < 0) {
        ::_exit(126);
    }
}

[[noreturn]] void becomeKerf(const std::vector<std::string>& arguments,
                             const std::map<std::string, std::string>& environment,
                             const std::string& out, const std::string& errors,
                             std::uint64_t addressSpace) {
    if (addressSpace > 0) {
        const rlimit limit{addressSpace, addressSpace};
        ::setrlimit(RLIMIT_AS, &limit);
    }
    for (const auto& [name, value] : environment) {
        ::setenv(name.c_str(), value.c_str(), 1);
    }
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, out, O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, errors, O_WRONLY | O_CREAT | O_TRUNC);
    std::string program = KERF_BINARY_DIR "/kerf";
    std::vector<char*> words{program.data()};
    std::vector<std::string> copies = arguments;
    for (std::string& word : copies) {
        words.push_back(word.data());
    }
    words.push_back(nullptr);
    ::execv(program.c_str(), words.data());
    ::_exit(127);
}

}  // namespace

ProgramRun runKerf(const std::vector<std::string>& arguments,
                   const std::map<std::string, std::string>& environment,
                   std::uint64_t addressSpace) {
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    const std::string errors = folder / "errors";
    const pid_t child = ::fork();
    if (child < 0) {
        throw std::runtime_error("fork failed");
    }
    if (child == 0) {
        becomeKerf(arguments, environment, out, errors, addressSpace);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readBytes(out), readBytes(errors)};
}

}  // namespace kerf::test
