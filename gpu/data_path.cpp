#include "gpu/data_path.h"

#include <cstdlib>

#include "gpu/program_folder.h"

namespace kerf::gpu {

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

}  // namespace kerf::gpu
