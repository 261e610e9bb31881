#pragma once

namespace kerf::test {

/// What a command of the shell prints on standard output, with a line "failed" behind it where its
/// exit code is not 0.
std::string outputOf(const std::string& command);

}  // namespace kerf::test
