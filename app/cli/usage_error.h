#pragma once

#include <stdexcept>

namespace kerf::app {

/// A mistake on the command line: what() is one sentence that says what and what to do. Exit code
/// 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace kerf::app
