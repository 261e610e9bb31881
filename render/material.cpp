#include <map>
#include <string>

#include "render/renderer.h"

namespace kerf::render {
namespace {

Material ball(float facets) {
    Material material;
    material.facets = facets;
    return material;
}

Material banana() {
    Material material;
    material.skin = {0.70f, 0.42f, 0.02f};
    material.inner = {0.60f, 0.50f, 0.27f};
    material.rind = {0.58f, 0.42f, 0.10f};
    material.pattern = MaterialPattern::pulp;
    material.mottle = 0.3f;
    material.spots = 0.7f;
    return material;
}

Material octopus() {
    Material material;
    material.skin = {0.40f, 0.045f, 0.12f};
    material.inner = {0.66f, 0.40f, 0.36f};
    material.rind = {0.42f, 0.08f, 0.13f};
    material.pattern = MaterialPattern::marbling;
    material.mottle = 0.5f;
    material.spots = 0.6f;
    return material;
}

Material clay() {
    Material material;
    material.skin = {0.045f, 0.17f, 0.23f};
    material.inner = {0.72f, 0.58f, 0.42f};
    material.rind = {0.30f, 0.36f, 0.34f};
    material.pattern = MaterialPattern::marbling;
    material.mottle = 0.2f;
    return material;
}

}  // namespace

Material materialFor(const std::string& modelName) {
    static const std::map<std::string, Material> kLooks = {{"sphere20", ball(0.8f)},
                                                           {"sphere80", ball(0.45f)},
                                                           {"sphere768", ball(0)},
                                                           {"banana", banana()},
                                                           {"octopus", octopus()}};
    const auto found = kLooks.find(modelName);
    return found != kLooks.end() ? found->second : clay();
}

}  // namespace kerf::render
