#include "app/files/jobs/own_programs.h"

#include <cstdlib>

#include "gpu/data_path.h"

namespace kerf::app {

namespace {

bool thisProgramReads = false;  // see readModelsWithThisProgram

}  // namespace

void readModelsWithThisProgram() {
    thisProgramReads = true;
}

std::filesystem::path importProgram() {
    if (const char* chosen = std::getenv("KERF_EXECUTABLE"); chosen != nullptr) {
        return chosen;
    }
    return thisProgramReads ? "/proc/self/exe" : programBeside("kerf");
}

std::filesystem::path programBeside(const std::string& name) {
    const std::filesystem::path folder = gpu::programFolder();
    const std::filesystem::path installed = folder.parent_path() / "libexec/kerf" / name;
    return std::filesystem::exists(installed) ? installed : folder / name;
}

}  // namespace kerf::app
