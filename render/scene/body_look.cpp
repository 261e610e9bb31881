#include "render/scene/body_look.h"

namespace kerf::render {
namespace {

// What skin and flesh add to the rind between them.
constexpr float kRindOfSkin = 0.5F;
constexpr float kRindOfFlesh = 0.15F;

BodyLook grey(Shading shading) {
    return {.skin = {0.20f, 0.20f, 0.20f},
            .inner = {0.36f, 0.36f, 0.36f},
            .rind = {0.46f, 0.46f, 0.46f},
            .rindShare = 0,
            .pattern = FleshPattern::even,
            .mottle = 0,
            .skinFinish = {.roughness = 0.6F, .gloss = 0.5F, .glow = 0},
            .cutFinish = {.roughness = 0.6F, .gloss = 0.5F, .glow = 0},
            .shading = shading};
}

/// By LookName.
const std::array<LookRow, kLookNames> kLooks{{
    {"Citrus",
     {.skin = {0.78f, 0.25f, 0.015f},
      .inner = {0.72f, 0.30f, 0.045f},
      .rind = {0.80f, 0.66f, 0.42f},
      .skinPattern = SkinPattern::peel,
      .pattern = FleshPattern::pulp,
      .skinFinish = {.roughness = 0.36F, .gloss = 1.1F, .glow = 0.2F},
      .cutFinish = {.roughness = 0.22F, .gloss = 1.2F, .glow = 0.5F}}},
    {"Banana",
     {.skin = {0.70f, 0.42f, 0.02f},
      .inner = {0.60f, 0.50f, 0.27f},
      .rind = {0.58f, 0.42f, 0.10f},
      .skinPattern = SkinPattern::spotted,
      .pattern = FleshPattern::rings,
      .mottle = 0.3f,
      .spots = 0.7f,
      .skinFinish = {.roughness = 0.48F, .gloss = 0.8F, .glow = 0.2F}}},
    {"Jelly",
     {.skin = {0.46f, 0.008f, 0.040f},
      .inner = {0.40f, 0.012f, 0.045f},
      .rind = {0.82f, 0.10f, 0.20f},
      .rindShare = 0,
      .pattern = FleshPattern::gel,
      .mottle = 0.05F,
      .skinFinish = {.roughness = 0.10F, .gloss = 2.0F, .glow = 1},
      .cutFinish = {.roughness = 0.16F, .gloss = 1.6F, .glow = 1}}},
    {"Meat",
     {.skin = {0.36f, 0.042f, 0.035f},
      .inner = {0.46f, 0.055f, 0.050f},
      .rind = {0.74f, 0.56f, 0.46f},
      .rindShare = 0.05F,
      .skinPattern = SkinPattern::meat,
      .pattern = FleshPattern::meat,
      .skinFinish = {.roughness = 0.30F, .gloss = 1.3F, .glow = 0.6F},
      .cutFinish = {.roughness = 0.26F, .gloss = 1.2F, .glow = 0.6F}}},
    {"Sponge",
     {.skin = {0.74f, 0.50f, 0.10f},
      .inner = {0.78f, 0.56f, 0.14f},
      .rind = {0.20f, 0.095f, 0.010f},
      .rindShare = 0,
      .skinPattern = SkinPattern::sponge,
      .pattern = FleshPattern::sponge,
      .skinFinish = {.roughness = 0.9F, .gloss = 0.15F, .glow = 0.35F},
      .cutFinish = {.roughness = 0.9F, .gloss = 0.15F, .glow = 0.35F}}},
    {"Wood",
     {.skin = {0.40f, 0.19f, 0.075f},
      .inner = {0.50f, 0.27f, 0.12f},
      .rind = {0.16f, 0.060f, 0.022f},
      .rindShare = 0,
      .skinPattern = SkinPattern::wood,
      .pattern = FleshPattern::wood,
      .skinFinish = {.roughness = 0.30F, .gloss = 0.9F, .glow = 0},
      .cutFinish = {.roughness = 0.55F, .gloss = 0.5F, .glow = 0}}},
    {"Clay",
     {.skin = {0.36f, 0.115f, 0.058f},
      .inner = {0.42f, 0.165f, 0.092f},
      .rind = {0.30f, 0.088f, 0.044f},
      .rindShare = 0.03F,
      .pattern = FleshPattern::even,
      .mottle = 0.22F,
      .skinFinish = {.roughness = 0.72F, .gloss = 0.45F, .glow = 0.1F},
      .cutFinish = {.roughness = 0.8F, .gloss = 0.35F, .glow = 0.1F}}},
    {"Marble",
     {.skin = {0.56f, 0.55f, 0.53f},
      .inner = {0.58f, 0.57f, 0.55f},
      .rind = {0.15f, 0.16f, 0.18f},
      .rindShare = 0,
      .skinPattern = SkinPattern::stone,
      .pattern = FleshPattern::stone,
      .skinFinish = {.roughness = 0.16F, .gloss = 1.3F, .glow = 0.3F},
      .cutFinish = {.roughness = 0.34F, .gloss = 0.9F, .glow = 0.3F}}},
    {"Plain",
     {.skin = {0.055f, 0.16f, 0.34f},
      .inner = {0.52f, 0.43f, 0.29f},
      .rind = {0.30f, 0.40f, 0.50f},
      .rindShare = 0.02F,
      .pattern = FleshPattern::even,
      .mottle = 0}},
    {"Plain grey", grey(Shading::lit)},
    {"Matcap: clay", grey(Shading::matcapClay)},
    {"Matcap: steel", grey(Shading::matcapSteel)},
    {"Matcap: normals", grey(Shading::normals)},
}};

/// What comes with Kerf as a ball: a fruit that grows nowhere.
const BodyLook kBall{.skin = {0.74f, 0.070f, 0.035f},
                     .inner = {0.42f, 0.46f, 0.17f},
                     .rind = {0.44f, 0.10f, 0.04f},
                     .skinPattern = SkinPattern::mottled,
                     .pattern = FleshPattern::pulp,
                     .skinFinish = {.roughness = 0.36F, .gloss = 1.1F, .glow = 0.2F},
                     .cutFinish = {.roughness = 0.22F, .gloss = 1.2F, .glow = 0.5F}};
const BodyLook kOctopus{.skin = {0.40f, 0.045f, 0.12f},
                        .inner = {0.66f, 0.40f, 0.36f},
                        .rind = {0.42f, 0.08f, 0.13f},
                        .skinPattern = SkinPattern::spotted,
                        .pattern = FleshPattern::marbling,
                        .mottle = 0.5f,
                        .skinFinish = {.roughness = 0.26F, .gloss = 1.3F, .glow = 0.5F},
                        .cutFinish = {.roughness = 0.30F, .gloss = 1, .glow = 0.6F}};
/// Of models that somebody brings along.
const BodyLook kGuest{.skin = {0.055f, 0.20f, 0.27f},
                      .inner = {0.72f, 0.58f, 0.42f},
                      .rind = {0.30f, 0.36f, 0.34f},
                      .pattern = FleshPattern::marbling,
                      .mottle = 0.2f};

}  // namespace

const LookRow& rowOf(LookName name) {
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
    if (modelName == "banana") {
        return rowOf(LookName::banana).look;
    }
    const bool isBall =
        modelName == "sphere20" || modelName == "sphere80" || modelName == "sphere768";
    return isBall ? kBall : modelName == "octopus" ? kOctopus : kGuest;
}

}  // namespace kerf::render
