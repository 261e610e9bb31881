#pragma once

#include <stdexcept>

#include "sim/base/text.h"

namespace kerf::app {

/// An input (model, session, image) is missing or invalid: what() is one printable sentence with
/// what, where and what to do. Exit code 3.
class InputError : public std::runtime_error {
  public:
    explicit InputError(const std::string& sentence) : std::runtime_error(printable(sentence)) {}
};

/// A result could not be written: what() is one sentence with the file, the system's reason and
/// what to do about it. Exit code 5.
class OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Something needs more memory than available: what() is one sentence with both amounts and what to
/// do. Nothing was allocated. Exit code 5.
class MemoryShortage : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// docs/cli.md lists them for users.
inline constexpr int kExitDone = 0;
inline constexpr int kExitCheckFailed = 1;  ///< pictures differ, replay diverged, invariant broken
inline constexpr int kExitUsage = 2;
inline constexpr int kExitInput = 3;     ///< missing or invalid
inline constexpr int kExitNoOpenGl = 4;  ///< no usable OpenGL 4.5
inline constexpr int kExitLimit = 5;     ///< out of memory, disk, time or another limit

}  // namespace kerf::app
