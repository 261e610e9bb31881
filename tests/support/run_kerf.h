#pragma once

namespace kerf::test {

/// What a run of the built program left.
struct ProgramRun {
    int exitCode = -1;  ///< -1 where a signal ended it
    std::string out;
    std::string errors;
};

/// Runs build/kerf with `arguments` and waits for it; `environment` is added to ours.
/// `addressSpace`: that it may take at most [bytes]; 0 for no limit.
ProgramRun runKerf(const std::vector<std::string>& arguments,
                   const std::map<std::string, std::string>& environment = {},
                   std::uint64_t addressSpace = 0);

}  // namespace kerf::test
