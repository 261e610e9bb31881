#pragma once

#include <filesystem>
#include <string>

namespace kerf::app {

/// Declares that this program has the verb `import-worker`; tests don't.
void readModelsWithThisProgram();
/// The program with the verb `import-worker`: $KERF_EXECUTABLE if set, else this program if
/// declared so, else kerf in gpu::programFolder().
std::filesystem::path importProgram();

/// A helper program of Kerf: in libexec/kerf of an installation, else in gpu::programFolder().
std::filesystem::path programBeside(const std::string& name);

}  // namespace kerf::app
