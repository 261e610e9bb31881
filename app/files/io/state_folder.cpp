#include "app/files/io/state_folder.h"

#include <cstdlib>

namespace kerf::app {

namespace fs = std::filesystem;

fs::path baseFolder(const char* variable, const char* usual) {
    if (const char* base = std::getenv(variable); base != nullptr && base[0] == '/') {
        return fs::path(base) / "kerf";
    }
    const char* const home = std::getenv("HOME");
    return home == nullptr || *home == '\0' ? fs::path() : fs::path(home) / usual / "kerf";
}

fs::path stateFolder() {
    return baseFolder("XDG_STATE_HOME", ".local/state");
}

}  // namespace kerf::app
