#include "render/scene/body_look.h"

#include <cmath>
#include <map>

namespace kerf::render {
namespace {

// What skin and flesh add to the rind between them.
constexpr float kRindOfSkin = 0.5F;
constexpr float kRindOfFlesh = 0.15F;

BodyLook citrus() {
    BodyLook look;
    look.skin = {0.78f, 0.25f, 0.015f};
    look.inner = {0.72f, 0.30f, 0.045f};
    look.rind = {0.80f, 0.66f, 0.42f};
    look.skinPattern = SkinPattern::peel;
    look.pattern = FleshPattern::pulp;
    look.skinFinish = {.roughness = 0.36F, .gloss = 1.1F, .glow = 0.2F};
    look.cutFinish = {.roughness = 0.22F, .gloss = 1.2F, .glow = 0.5F};
    return look;
}

BodyLook jelly() {
    BodyLook look;
    look.skin = {0.46f, 0.008f, 0.040f};
    look.inner = {0.40f, 0.012f, 0.045f};
    look.rind = {0.82f, 0.10f, 0.20f};
    look.rindShare = 0;
    look.pattern = FleshPattern::gel;
    look.mottle = 0.05F;
    look.skinFinish = {.roughness = 0.10F, .gloss = 2.0F, .glow = 1};
    look.cutFinish = {.roughness = 0.16F, .gloss = 1.6F, .glow = 1};
    return look;
}

BodyLook meat() {
    BodyLook look;
    look.skin = {0.36f, 0.042f, 0.035f};
    look.inner = {0.46f, 0.055f, 0.050f};
    look.rind = {0.74f, 0.56f, 0.46f};
    look.rindShare = 0.05F;
    look.skinPattern = SkinPattern::meat;
    look.pattern = FleshPattern::meat;
    look.skinFinish = {.roughness = 0.30F, .gloss = 1.3F, .glow = 0.6F};
    look.cutFinish = {.roughness = 0.26F, .gloss = 1.2F, .glow = 0.6F};
    return look;
}

BodyLook sponge() {
    BodyLook look;
    look.skin = {0.74f, 0.50f, 0.10f};
    look.inner = {0.78f, 0.56f, 0.14f};
    look.rind = {0.20f, 0.095f, 0.010f};
    look.rindShare = 0;
    look.skinPattern = SkinPattern::sponge;
    look.pattern = FleshPattern::sponge;
    look.skinFinish = look.cutFinish = {.roughness = 0.9F, .gloss = 0.15F, .glow = 0.35F};
    return look;
}

BodyLook wood() {
    BodyLook look;
    look.skin = {0.40f, 0.19f, 0.075f};
    look.inner = {0.50f, 0.27f, 0.12f};
    look.rind = {0.16f, 0.060f, 0.022f};
    look.rindShare = 0;
    look.skinPattern = SkinPattern::wood;
    look.pattern = FleshPattern::wood;
    look.skinFinish = {.roughness = 0.30F, .gloss = 0.9F, .glow = 0};
    look.cutFinish = {.roughness = 0.55F, .gloss = 0.5F, .glow = 0};
    return look;
}

BodyLook clay() {
    BodyLook look;
    look.skin = {0.36f, 0.115f, 0.058f};
    look.inner = {0.42f, 0.165f, 0.092f};
    look.rind = {0.30f, 0.088f, 0.044f};
    look.rindShare = 0.03F;
    look.pattern = FleshPattern::even;
    look.mottle = 0.22F;
    look.skinFinish = {.roughness = 0.72F, .gloss = 0.45F, .glow = 0.1F};
    look.cutFinish = {.roughness = 0.8F, .gloss = 0.35F, .glow = 0.1F};
    return look;
}

BodyLook marble() {
    BodyLook look;
    look.skin = {0.56f, 0.55f, 0.53f};
    look.inner = {0.58f, 0.57f, 0.55f};
    look.rind = {0.15f, 0.16f, 0.18f};
    look.rindShare = 0;
    look.skinPattern = SkinPattern::stone;
    look.pattern = FleshPattern::stone;
    look.skinFinish = {.roughness = 0.16F, .gloss = 1.3F, .glow = 0.3F};
    look.cutFinish = {.roughness = 0.34F, .gloss = 0.9F, .glow = 0.3F};
    return look;
}

BodyLook plain() {
    BodyLook look;
    look.skin = {0.055f, 0.16f, 0.34f};
    look.inner = {0.52f, 0.43f, 0.29f};
    look.rind = {0.30f, 0.40f, 0.50f};
    look.rindShare = 0.02F;
    look.pattern = FleshPattern::even;
    look.mottle = 0;
    return look;
}

BodyLook grey() {
    BodyLook look = plain();
    look.skin = {0.20f, 0.20f, 0.20f};
    look.inner = {0.36f, 0.36f, 0.36f};
    look.rind = {0.46f, 0.46f, 0.46f};
    look.rindShare = 0;
    look.skinFinish = look.cutFinish = {.roughness = 0.6F, .gloss = 0.5F, .glow = 0};
    return look;
}

BodyLook matcap(Shading shading) {
    BodyLook look = grey();
    look.shading = shading;
    return look;
}

/// What comes with Kerf as a ball: a fruit that grows nowhere.
BodyLook ball() {
    BodyLook look = citrus();
    look.skin = {0.74f, 0.070f, 0.035f};
    look.inner = {0.42f, 0.46f, 0.17f};
    look.rind = {0.44f, 0.10f, 0.04f};
    look.skinPattern = SkinPattern::mottled;
    return look;
}

BodyLook banana() {
    BodyLook look;
    look.skin = {0.70f, 0.42f, 0.02f};
    look.inner = {0.60f, 0.50f, 0.27f};
    look.rind = {0.58f, 0.42f, 0.10f};
    look.skinPattern = SkinPattern::spotted;
    look.pattern = FleshPattern::rings;
    look.mottle = 0.3f;
    look.spots = 0.7f;
    look.skinFinish = {.roughness = 0.48F, .gloss = 0.8F, .glow = 0.2F};
    return look;
}

BodyLook octopus() {
    BodyLook look;
    look.skin = {0.40f, 0.045f, 0.12f};
    look.inner = {0.66f, 0.40f, 0.36f};
    look.rind = {0.42f, 0.08f, 0.13f};
    look.skinPattern = SkinPattern::spotted;
    look.pattern = FleshPattern::marbling;
    look.mottle = 0.5f;
    look.skinFinish = {.roughness = 0.26F, .gloss = 1.3F, .glow = 0.5F};
    look.cutFinish = {.roughness = 0.30F, .gloss = 1, .glow = 0.6F};
    return look;
}

/// Of models that somebody brings along.
BodyLook guest() {
    BodyLook look;
    look.skin = {0.055f, 0.20f, 0.27f};
    look.inner = {0.72f, 0.58f, 0.42f};
    look.rind = {0.30f, 0.36f, 0.34f};
    look.pattern = FleshPattern::marbling;
    look.mottle = 0.2f;
    return look;
}

}  // namespace

const LookRow& rowOf(LookName name) {
    static const std::array<LookRow, kLookNames> kLooks{{
        {"Citrus", citrus()},
        {"Banana", banana()},
        {"Jelly", jelly()},
        {"Meat", meat()},
        {"Sponge", sponge()},
        {"Wood", wood()},
        {"Clay", clay()},
        {"Marble", marble()},
        {"Plain", plain()},
        {"Plain grey", grey()},
        {"Matcap: clay", matcap(Shading::matcapClay)},
        {"Matcap: steel", matcap(Shading::matcapSteel)},
        {"Matcap: normals", matcap(Shading::normals)},
    }};
    return kLooks.at(static_cast<std::size_t>(name));
}

BodyLook colored(const BodyLook& own, const ChosenColors& colors) {
    BodyLook look = colors.look ? rowOf(*colors.look).look : own;
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
    static const std::map<std::string, BodyLook> kLooks = {{"sphere20", ball()},
                                                           {"sphere80", ball()},
                                                           {"sphere768", ball()},
                                                           {"banana", banana()},
                                                           {"octopus", octopus()}};
    const auto found = kLooks.find(modelName);
    return found != kLooks.end() ? found->second : guest();
}

}  // namespace kerf::render
