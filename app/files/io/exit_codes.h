#pragma once

namespace kerf::app {

// docs/cli.md lists them for users.
inline constexpr int kExitDone = 0;
inline constexpr int kExitCheckFailed = 1;  ///< pictures differ, replay diverged, invariant broken
inline constexpr int kExitUsage = 2;
inline constexpr int kExitInput = 3;     ///< missing or invalid
inline constexpr int kExitNoOpenGl = 4;  ///< no usable OpenGL 4.5
inline constexpr int kExitLimit = 5;     ///< out of memory, disk, time or another limit

}  // namespace kerf::app
