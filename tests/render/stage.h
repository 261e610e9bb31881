// A body before a camera, small enough to draw many times.
#pragma once

#include "render/renderer.h"
#include "tests/support/body_upload.h"

namespace kerf::render {

inline constexpr int kWidth = 320;
inline constexpr int kHeight = 180;

/// A body with all that a picture of it needs.
struct Stage {
    explicit Stage(const SurfaceMesh& mesh, std::vector<Vec3> cutSkinNormals = {})
        : body(mesh, std::move(cutSkinNormals)) {
        scene.body = body.view();
        scene.restBounds = body.restBounds;
        scene.focus = body.bounds;
        scene.look = lookFor("sphere768");
        scene.floor = body.bounds.low.y();
        camera.frame(body.bounds);
    }
    Image picture(Renderer& renderer) const {
        renderer.draw(scene, camera, kWidth, kHeight);
        return renderer.readPicture();
    }
    test::UploadedBody body;
    SceneView scene;
    Camera camera;
};

}  // namespace kerf::render
