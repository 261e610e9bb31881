#include "app/cli/program.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <new>

#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/memory_means.h"
#include "app/files/io/system_file.h"
#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "sim/base/freed_memory.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

/// Standard output carries results alone, so the log goes to standard error.
void setUpLog() {
    const char* noColor = std::getenv("NO_COLOR");
    const bool plain = noColor != nullptr && *noColor != '\0';
    const auto mode = plain ? spdlog::color_mode::never : spdlog::color_mode::automatic;
    spdlog::set_default_logger(spdlog::stderr_color_mt("kerf", mode));
    spdlog::set_pattern("%^%l%$: %v");
}

/// A result that nobody got is no success: a full disk behind `kerf inspect MODEL --json > FILE`.
int checkStandardOutput(int exitCode) {
    std::cout.flush();
    return std::cout ? exitCode
                     : complain(
                           "Standard output could not be written; is the disk full, or the output "
                           "closed?",
                           kExitLimit);
}

/// `what` may end with a full stop.
int complainOfUse(std::string what) {
    what.erase(what.find_last_not_of('.') + 1);
    return complain(what + "; see kerf --help.", kExitUsage);
}

}  // namespace

void setUpProgram() {
    holdStandardStreams();
    std::signal(SIGXFSZ, SIG_IGN);  // a write beyond `ulimit -f` fails with a sentence instead
    keepFreedMemory();
    setUpLog();
}

std::optional<int> parseWords(CLI::App& parser, int argc, char** argv) {
    try {
        parser.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        // Help and version go to standard output; a mistake is one sentence.
        return error.get_exit_code() == 0 ? parser.exit(error, std::cout, std::cerr)
                                          : complainOfUse(error.what());
    }
    return std::nullopt;
}

int runSafely(const std::function<int()>& verb) {
    try {
        return checkStandardOutput(verb());
    } catch (const UsageError& error) {
        return complainOfUse(error.what());
    } catch (...) {
        const auto [sentence, exitCode] = complaintAboutThrown();
        return complain(sentence, exitCode);
    }
}

Complaint complaintAboutThrown() {
    try {
        throw;
    } catch (const InputError& error) {
        return {error.what(), kExitInput};
    } catch (const gpu::ContextError& error) {
        return {error.what(), kExitNoOpenGl};
    } catch (const gpu::ShaderError& error) {
        return {error.what(), kExitNoOpenGl};
    } catch (const gpu::OutOfMemory& error) {
        return {error.what(), kExitLimit};
    } catch (const MemoryShortage& error) {
        return {error.what(), kExitLimit};
    } catch (const OutputError& error) {
        return {error.what(), kExitLimit};
    } catch (const std::filesystem::filesystem_error& error) {
        return {error.path1().string() + ": " + error.code().message() + ".", kExitInput};
    } catch (const std::bad_alloc&) {
        return {outOfMemory("Kerf"), kExitLimit};
    }
}

int complain(const std::string& sentence, int exitCode) {
    std::cerr << "kerf: " << printable(sentence) << "\n";
    return exitCode;
}

}  // namespace kerf::app
