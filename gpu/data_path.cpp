#include "gpu/data_path.h"

#include <cstdlib>
#include <system_error>

namespace kerf::gpu {

namespace {

namespace fs = std::filesystem;

/// Empty for that of the executable.
fs::path& namedFolder() {
    static fs::path folder;
    return folder;
}

}  // namespace

namespace fs = std::filesystem;

fs::path shaderRoot() {
    return dataPath("shaders");
}

fs::path dataPath(std::string_view relative) {
    if (const char* folder = std::getenv("KERF_DATA_DIR"); folder != nullptr && *folder != '\0') {
        return fs::path(folder) / relative;
    }
    const fs::path beside = programFolder();
    const fs::path above = beside.parent_path();
    for (const fs::path& folder : {beside, above, above / "share/kerf"}) {
        if (fs::exists(folder / relative)) {
            return folder / relative;
        }
    }
    return fs::path(KERF_SOURCE_DIR) / relative;
}

fs::path userPath(const char* variable, const char* usual, std::string_view name) {
    if (const char* base = std::getenv(variable); base != nullptr && base[0] == '/') {
        return fs::path(base) / "kerf" / name;
    }
    const char* const home = std::getenv("HOME");
    return home == nullptr || *home == '\0' ? fs::path() : fs::path(home) / usual / "kerf" / name;
}

fs::path statePath(std::string_view name) {
    return userPath("XDG_STATE_HOME", ".local/state", name);
}

fs::path programFolder() {
    std::error_code failed;
    return namedFolder().empty() ? fs::read_symlink("/proc/self/exe", failed).parent_path()
                                 : namedFolder();
}

void setProgramFolder(fs::path folder) {
    namedFolder() = std::move(folder);
}

}  // namespace kerf::gpu
