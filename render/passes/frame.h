#pragma once

#include "gpu/program.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace kerf::render {

/// The blade as it is drawn, from the end that is held to its tip; none where there is none.
std::optional<Blade> drawnBlade(const SceneView& scene, double bodySize);
/// The height of the drawn blade, from its edge to its back [m]; without pushing only for display.
double bladeHeight(const SceneView& scene, double bodySize);

/// The values that all passes of a frame share, computed from the scene and the camera.
struct Frame {
    int width = 0;
    int height = 0;
    Eigen::Matrix4f viewProjection = Eigen::Matrix4f::Identity();
    Eigen::Matrix4f pictureToWorld = Eigen::Matrix4f::Identity();  ///< clip space to eye offsets
    Vec3f eye = Vec3f::Zero();
    bool hasBody = false;
    bool bright = false;                                        ///< see SceneView
    float bodySize = 1;                                         ///< diagonal at rest [m]
    Bounds focus;                                               ///< never empty
    Vec3f keyDirection = Vec3f::UnitY();                        ///< towards the key light
    Eigen::Matrix4f lightMatrix = Eigen::Matrix4f::Identity();  ///< world to the shadow map
    float shadowTexel = 0;                                      ///< [m]
    /// World to the map of the floor's shade, straight up and sheared along the key light; depth 0
    /// at the floor, 1 at shadeRange [m] above it; shadeReach is half its side [m].
    Eigen::Matrix4f shadeMatrix = Eigen::Matrix4f::Identity();
    Eigen::Matrix4f shadeMatrixAlongKey = Eigen::Matrix4f::Identity();
    float shadeRange = 1;
    float shadeReach = 1;
    std::array<Vec3f, 4> mattLight{};    ///< see Environment::matt
    const gpu::Buffer* looks = nullptr;  ///< two vec4 per piece (see kBindLooks); never empty
    std::uint32_t lookCount = 0;
};

/// `shadowSize`: side of the shadow map [px].
Frame frameOf(const SceneView& scene, const Camera& camera, int width, int height, int shadowSize);

/// Buffer and uniform of piece_looks.glsl.
void bindLooks(const gpu::Program& program, const Frame& frame);
/// bindLooks() for objects other than pieces of the body.
void bindNoLooks(const gpu::Program& program, const Frame& frame);

/// Uniforms of light.glsl.
void setLight(const gpu::Program& program, const Frame& frame);

}  // namespace kerf::render
