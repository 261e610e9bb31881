#pragma once

#include "sim/base/math.h"

namespace kerf::render {

/// The pattern of the skin, by the number that shaders/render/skin.glsl has for it.
enum class SkinPattern { mottled, spotted, peel, meat, sponge, wood, stone };
inline constexpr std::size_t kSkinPatterns = 7;
/// The pattern that a cut shows inside a body, by the number that shaders/render/inner.glsl has.
enum class FleshPattern { pulp, rings, marbling, gel, meat, sponge, wood, stone, even };
inline constexpr std::size_t kFleshPatterns = 9;

/// The shading: by a light in the scene, or by a picture of a lit ball (a matcap), which moves with
/// the view.
enum class Shading { lit, matcapClay, matcapSteel, normals };

/// The reflectance of a surface, besides its colour.
struct Finish {
    float roughness = 0.38F;  ///< of the reflection: 0 a mirror, 1 none to be seen
    float gloss = 1;          ///< strength of the reflection; 1 is that of fruit, skin and plastics
    float glow = 0.2F;        ///< subsurface scattering, 0 to 1
};

/// Colours and inner structure of a body, evaluated in rest space so that they stay attached.
struct BodyLook {
    Eigen::Vector3f skin = {0.74f, 0.070f, 0.035f};  ///< linear albedo
    Eigen::Vector3f inner = {0.42f, 0.46f, 0.17f};   ///< linear albedo of the cut faces
    /// Linear albedo just below the skin; of solid patterns that of veins, rings and pores.
    Eigen::Vector3f rind = {0.44f, 0.10f, 0.04f};
    float rindShare = 0.11F;  ///< of the depth; 0: the inside begins at the skin
    SkinPattern skinPattern = SkinPattern::mottled;
    FleshPattern pattern = FleshPattern::rings;
    float mottle = 0.15f;  ///< strength of the skin's broad colour variation, 0 to 1
    float spots = 0.6F;    ///< strength of the spots of a spotted skin, 0 to 1
    Finish skinFinish{};
    Finish cutFinish{.roughness = 0.42F, .gloss = 0.7F, .glow = 0.35F};
    Shading shading = Shading::lit;
};

/// A look that can be chosen for any body, in the order of kLooks.
enum class LookName {
    citrus,
    banana,
    jelly,
    meat,
    sponge,
    wood,
    clay,
    marble,
    plain,
    grey,
    matcapClay,
    matcapSteel,
    normals
};
inline constexpr std::size_t kLookNames = 13;
/// The words for them in sessions.
inline constexpr std::array<std::string_view, kLookNames> kLookWords{
    "citrus", "banana", "jelly", "meat",        "sponge",       "wood",   "clay",
    "marble", "plain",  "grey",  "matcap-clay", "matcap-steel", "normals"};

/// A row of the table of looks.
struct LookRow {
    const char* label = "";  ///< for people
    BodyLook look;
};
/// The row of a look.
const LookRow& rowOf(LookName name);

/// The look of a builtin model by name ("sphere768", "banana", "octopus"); a default for others.
BodyLook lookFor(const std::string& modelName);

/// Look and colours chosen instead of the model's own; display colours (sRGB, 0 to 1).
struct ChosenColors {
    std::optional<LookName> look;
    std::optional<Vec3> skin;
    std::optional<Vec3> flesh;  ///< of the cut faces
    bool ofLook = false;        ///< of the skin, even where the model's file has its own
    /// Whether the skin shows what the model's file has.
    bool showOwn() const { return !ofLook && !look && !skin; }
    bool operator==(const ChosenColors&) const = default;
    bool any() const { return *this != ChosenColors{}; }
};
/// The chosen look, or else `own`, in the chosen colours; its rind, between skin and flesh, follows
/// them.
BodyLook colored(const BodyLook& own, const ChosenColors& colors);

/// From linear light to display colours, and back, each 0 to 1.
Vec3 toDisplay(const Eigen::Vector3f& linear);
Eigen::Vector3f toLinear(const Vec3& display);

}  // namespace kerf::render
