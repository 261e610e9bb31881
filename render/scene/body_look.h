#pragma once

#include <optional>
#include <string>

#include "sim/base/math.h"

namespace kerf::render {

/// The pattern that a cut shows inside a body.
enum class FleshPattern { pulp, rings, marbling };
/// Colours and inner structure of a body, evaluated in rest space so that they stay attached.
struct BodyLook {
    Eigen::Vector3f skin = {0.74f, 0.070f, 0.035f};  ///< linear albedo
    Eigen::Vector3f inner = {0.42f, 0.46f, 0.17f};   ///< linear albedo of the cut faces
    Eigen::Vector3f rind = {0.44f, 0.10f, 0.04f};    ///< linear albedo just below the skin
    FleshPattern pattern = FleshPattern::rings;
    float mottle = 0.15f;  ///< strength of the skin's broad colour variation, 0 to 1
    float spots = 0;       ///< strength of the spots on the skin, 0 to 1
    float facets = 0;      ///< share of flat shading on the skin, for very coarse models, 0 to 1
};

/// The look of a builtin model by name ("sphere768", "banana", "octopus"); a default for others.
BodyLook lookFor(const std::string& modelName);

/// Colours that a person chose, as displays take them (sRGB, 0 to 1).
struct ChosenColors {
    std::optional<Vec3> skin;
    std::optional<Vec3> flesh;  ///< of the cut faces
    bool ofLook = false;        ///< of the skin, even where the model's file has its own
    /// Whether the skin shows what the model's file has.
    bool showOwn() const { return !ofLook && !skin; }
    bool operator==(const ChosenColors&) const = default;
};
/// The look in these colours; its rind, between skin and flesh, follows them.
BodyLook colored(BodyLook look, const ChosenColors& colors);

/// From linear light to what displays take, and back, each 0 to 1.
Vec3 toDisplay(const Eigen::Vector3f& linear);
Eigen::Vector3f toLinear(const Vec3& display);

}  // namespace kerf::render
