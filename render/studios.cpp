#include "render/studios.h"

#include <spdlog/spdlog.h>

#include <cstdlib>
#include <exception>

#include "gpu/data_path.h"

namespace kerf::render {
namespace {

std::filesystem::path fileOf(bool bright) {
    const char* chosen = std::getenv("KERF_ENVIRONMENT");
    if (chosen != nullptr && *chosen != '\0') {
        return chosen;
    }
    return gpu::dataPath(bright ? "assets/environments/studio-bright.hdr"
                                : "assets/environments/studio-dark.hdr");
}

Panorama evenLight() {
    return {2, 1, {Vec3f::Constant(0.3F), Vec3f::Constant(0.3F)}};
}

Environment environmentOf(bool bright) {
    try {
        return prefilter(readPanorama(fileOf(bright)));
    } catch (const std::exception& problem) {
        spdlog::warn("{} The light is even instead.", problem.what());
        return prefilter(evenLight());
    }
}

}  // namespace

const EnvironmentTexture& Studios::of(bool bright) {
    std::optional<EnvironmentTexture>& texture = textures_[bright ? 1 : 0];
    if (!texture) {
        texture.emplace(environmentOf(bright));
    }
    return *texture;
}

}  // namespace kerf::render
