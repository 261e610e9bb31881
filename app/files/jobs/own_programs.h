#pragma once

#include <filesystem>
#include <string>

namespace kerf::app {

/// Says that this program has the verb `import-worker`, whatever its name; tests don't.
void readModelsWithThisProgram();
/// The program that has the verb `import-worker`: $KERF_EXECUTABLE where set, else this program
/// where it said so, else kerf in gpu::programFolder().
std::filesystem::path importProgram();

/// The program of that name that Kerf starts: in libexec/kerf where Kerf is installed, else in
/// gpu::programFolder().
std::filesystem::path programBeside(const std::string& name);

}  // namespace kerf::app
