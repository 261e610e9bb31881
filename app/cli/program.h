#pragma once

#include <CLI/CLI.hpp>

// How the program kerf begins and ends.
namespace kerf::app {

inline constexpr const char* kExitCodes =
    "Exit codes: 0 done, 1 a check failed, 2 wrong usage, 3 input missing or invalid,\n"
    "4 no usable OpenGL 4.5, 5 out of memory or another limit.";

/// Sets up standard streams, signals, memory and log. Call it first.
void setUpProgram();

/// The exit code if the arguments end the program: by a mistake, or by asking for help.
std::optional<int> parseWords(CLI::App& parser, int argc, char** argv);
/// Runs a verb; turns its errors into a sentence and an exit code.
int runSafely(const std::function<int()>& verb);
/// The message about an error of a verb, and its exit code.
struct Complaint {
    std::string sentence;
    int exitCode;
};
/// For the exception being handled; one that no verb throws is rethrown.
Complaint complaintAboutThrown();
/// Prints the sentence on standard error; returns the code.
int complain(const std::string& sentence, int exitCode);

}  // namespace kerf::app
