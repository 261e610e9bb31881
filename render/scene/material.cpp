#include "render/scene/material.h"

#include <cmath>
#include <map>

namespace kerf::render {
namespace {

// What skin and flesh add to the rind between them.
constexpr float kRindOfSkin = 0.5F;
constexpr float kRindOfFlesh = 0.15F;

Material ball(float facets) {
    Material material;
    material.pattern = MaterialPattern::pulp;
    material.facets = facets;
    return material;
}

Material banana() {
    Material material;
    material.skin = {0.70f, 0.42f, 0.02f};
    material.inner = {0.60f, 0.50f, 0.27f};
    material.rind = {0.58f, 0.42f, 0.10f};
    material.pattern = MaterialPattern::rings;
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

Material colored(Material material, const ChosenColors& colors) {
    if (colors.skin) {
        material.skin = toLinear(*colors.skin);
    }
    if (colors.flesh) {
        material.inner = toLinear(*colors.flesh);
    }
    if (colors.skin || colors.flesh) {
        material.rind = kRindOfSkin * material.skin + kRindOfFlesh * material.inner;
    }
    return material;
}

Vec3 toDisplay(const Eigen::Vector3f& linear) {
    return linear.cast<double>().unaryExpr(
        [](double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; });
}

Eigen::Vector3f toLinear(const Vec3& display) {
    const Vec3 linear = display.unaryExpr(
        [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); });
    return linear.cast<float>();
}

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
