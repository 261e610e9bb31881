#include "gpu/program_folder.h"

#include <system_error>
#include <utility>

namespace kerf::gpu {
namespace {

namespace fs = std::filesystem;

/// Empty for that of the executable.
fs::path& namedFolder() {
    static fs::path folder;
    return folder;
}

}  // namespace

fs::path programFolder() {
    std::error_code failed;
    return namedFolder().empty() ? fs::read_symlink("/proc/self/exe", failed).parent_path()
                                 : namedFolder();
}

void setProgramFolder(fs::path folder) {
    namedFolder() = std::move(folder);
}

}  // namespace kerf::gpu
