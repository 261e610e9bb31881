#include "render/scene/body_look.h"

#include <cmath>
#include <map>

namespace kerf::render {
namespace {

// What skin and flesh add to the rind between them.
constexpr float kRindOfSkin = 0.5F;
constexpr float kRindOfFlesh = 0.15F;

BodyLook ball(float facets) {
    BodyLook look;
    look.pattern = FleshPattern::pulp;
    look.facets = facets;
    return look;
}

BodyLook banana() {
    BodyLook look;
    look.skin = {0.70f, 0.42f, 0.02f};
    look.inner = {0.60f, 0.50f, 0.27f};
    look.rind = {0.58f, 0.42f, 0.10f};
    look.pattern = FleshPattern::rings;
    look.mottle = 0.3f;
    look.spots = 0.7f;
    return look;
}

BodyLook octopus() {
    BodyLook look;
    look.skin = {0.40f, 0.045f, 0.12f};
    look.inner = {0.66f, 0.40f, 0.36f};
    look.rind = {0.42f, 0.08f, 0.13f};
    look.pattern = FleshPattern::marbling;
    look.mottle = 0.5f;
    look.spots = 0.6f;
    return look;
}

BodyLook clay() {
    BodyLook look;
    look.skin = {0.045f, 0.17f, 0.23f};
    look.inner = {0.72f, 0.58f, 0.42f};
    look.rind = {0.30f, 0.36f, 0.34f};
    look.pattern = FleshPattern::marbling;
    look.mottle = 0.2f;
    return look;
}

}  // namespace

BodyLook colored(BodyLook look, const ChosenColors& colors) {
    if (colors.skin) {
        look.skin = toLinear(*colors.skin);
    }
    if (colors.flesh) {
        look.inner = toLinear(*colors.flesh);
    }
    if (colors.skin || colors.flesh) {
        look.rind = kRindOfSkin * look.skin + kRindOfFlesh * look.inner;
    }
    return look;
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

BodyLook lookFor(const std::string& modelName) {
    static const std::map<std::string, BodyLook> kLooks = {{"sphere20", ball(0.8f)},
                                                           {"sphere80", ball(0.45f)},
                                                           {"sphere768", ball(0)},
                                                           {"banana", banana()},
                                                           {"octopus", octopus()}};
    const auto found = kLooks.find(modelName);
    return found != kLooks.end() ? found->second : clay();
}

}  // namespace kerf::render
