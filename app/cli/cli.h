#pragma once

namespace kerf::app {

/// Runs the program: parses the arguments, runs a verb or the editor, and turns every error into
/// one sentence on standard error and an exit code.
int runCommandLine(int argc, char** argv);

}  // namespace kerf::app
