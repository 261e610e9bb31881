#pragma once

#include <sys/types.h>

#include <csignal>

#include "app/files/io/system_file.h"

namespace kerf::app {

/// How a child process ended.
struct ChildEnd {
    int exitCode = -1;  ///< -1 if a signal ended it
    int signal = 0;     ///< that signal, else 0
};

/// A program to run as a child. It inherits the descriptors of its streams; one of -1 leads
/// nowhere.
struct ChildOrder {
    std::vector<std::string> words;  ///< its path, or its name on the PATH, and its arguments
    int input = -1;
    int output = -1;
    int log = -1;                             ///< standard error
    std::vector<std::string> variables = {};  ///< more of the environment: "NAME=value"
    bool inheritsFiles = false;  ///< also other files that are not closed on exec, as of a RunLock
};

/// A child process. It ends with this object, with the thread that started it, and with this
/// process.
class ChildProcess {
  public:
    /// Throws std::system_error if it can't be started.
    explicit ChildProcess(const ChildOrder& order);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Makes it end now.
    void kill() const;
    /// Waits for its end, once.
    ChildEnd wait();

  private:
    pid_t id_;  ///< 0 once it has ended
};

/// Takes what a child writes, block by block.
using BlockReader = std::function<void(std::string_view block)>;
/// Reads two streams of a child until both end. `patience` says, again and again, how long to wait
/// at most [ms]; below 0 the rest is left, and it returns false.
bool readStreams(Pipe& output, const BlockReader& ofOutput, Pipe& log, const BlockReader& ofLog,
                 const std::function<int()>& patience);

/// During its lifetime Ctrl+C (SIGINT) and SIGTERM don't end this program but request a stop, so
/// that it can report and keep what was done. One at a time.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Whether a stop was requested since it was made.
    static bool requested();

  private:
    struct sigaction earlierInterrupt_ {};
    struct sigaction earlierTerminate_ {};
};

/// Declares that this program is kerf; tests are not.
void runThisProgram();
/// The program kerf, to start as a child: $KERF_EXECUTABLE if set, else this program if declared
/// so, else kerf in gpu::programFolder().
std::filesystem::path kerfProgram();

/// A helper program of Kerf: in libexec/kerf of an installation, else in gpu::programFolder().
std::filesystem::path programBeside(const std::string& name);

}  // namespace kerf::app
