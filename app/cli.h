#pragma once

namespace kerf::app {

// Exit codes; docs/cli.md lists them for users.
inline constexpr int kExitDone = 0;
inline constexpr int kExitCheckFailed = 1;  ///< image differs, replay diverged, invariant broken
inline constexpr int kExitUsage = 2;
inline constexpr int kExitInput = 3;     ///< missing or invalid
inline constexpr int kExitNoOpenGl = 4;  ///< no usable OpenGL 4.5
inline constexpr int kExitLimit = 5;     ///< out of memory, disk, time or another limit

/// The whole program: parses the arguments, runs a verb or the editor, and turns every error into
/// one sentence on standard error and an exit code.
int runCommandLine(int argc, char** argv);

}  // namespace kerf::app
