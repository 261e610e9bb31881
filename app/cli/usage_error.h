#pragma once

#include <stdexcept>

namespace kerf::app {

/// The command line asks for something that can't be: what() is one sentence that says what and
/// what to do. Exit code 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace kerf::app
