#pragma once

#include "gpu/program.h"
#include "render/renderer.h"

namespace kerf::render {

/// What all passes of one picture share, worked out from the scene and the camera.
struct Frame {
    int width = 0;
    int height = 0;
    Eigen::Matrix4f viewProjection = Eigen::Matrix4f::Identity();
    Vec3f eye = Vec3f::Zero();
    bool hasBody = false;
    float bodySize = 1;                                          ///< diagonal at rest [m]
    Bounds focus;                                                ///< never empty
    Vec3f keyDirection = Vec3f::UnitY();                         ///< towards the key light
    Eigen::Matrix4f lightMatrix = Eigen::Matrix4f::Identity();   ///< world to the shadow map
    float shadowTexel = 0;                                       ///< [m]
    Eigen::Matrix4f groundMatrix = Eigen::Matrix4f::Identity();  ///< world to the contact map
    float groundRange = 1;  ///< height that the contact map's depth range stands for [m]
    float groundReach = 1;  ///< half side of the contact map [m]
};

Frame frameOf(const SceneView& scene, const Camera& camera, int width, int height, int shadowSize);

/// Uniforms of light.glsl.
void setLight(const gpu::Program& program, const Frame& frame);

}  // namespace kerf::render
