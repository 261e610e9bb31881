#include "app/files/io/state_folder.h"

#include <cstdlib>

namespace kerf::app {

namespace fs = std::filesystem;

fs::path stateFolder() {
    if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && state[0] == '/') {
        return fs::path(state) / "kerf";
    }
    const char* const home = std::getenv("HOME");
    return home == nullptr || *home == '\0' ? fs::path() : fs::path(home) / ".local/state/kerf";
}

}  // namespace kerf::app
