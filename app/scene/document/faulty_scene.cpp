#include "app/scene/document/faulty_scene.h"

#include "app/files/import/model_units.h"
#include "render/scene/body_look.h"
#include "sim/base/math.h"

namespace kerf::app {
namespace {

/// What a triangle has: others would stand far away where a file is damaged.
std::vector<Vec3> drawnPoints(const TriangleSoup& soup) {
    std::vector<Vec3> points;
    const int count = static_cast<int>(soup.positions.size());
    for (const Triangle& t : soup.triangles) {
        for (const int v : t) {
            if (v >= 0 && v < count && soup.positions[v].allFinite()) {
                points.push_back(soup.positions[v]);
            }
        }
    }
    return points;
}

/// In the scene, upright and in metres.
TriangleSoup placed(const FoundFaults& found, const std::filesystem::path& file) {
    const std::vector<Vec3> points = drawnPoints(found.soup);
    TriangleSoup soup{found.soup.positions, found.soup.triangles, {}};
    if (points.empty()) {
        return soup;
    }
    const PlacementMap map(standing(guessUnits(file, boxOf(points), found.units), points));
    for (Vec3& p : soup.positions) {
        p = map.toScene(p);
    }
    return soup;
}

}  // namespace

FaultyScene::FaultyScene(const FoundFaults& found, const std::filesystem::path& file)
    : bounds_(boxOf(drawnPoints(placed(found, file)))),
      body_(placed(found, file)),
      marks_(std::make_shared<const std::vector<render::Marks>>(marksOf(found))) {}

render::SceneView FaultyScene::view() const {
    render::SceneView view;
    view.body = body_.view();
    view.hasWalls = false;
    view.look = render::rowOf(render::LookName::grey).look;
    view.restBounds = bounds_;
    view.focus = bounds_;
    if (!bounds_.empty()) {
        view.floor = bounds_.low.y();
    }
    view.marks = marks_;
    return view;
}

render::Camera FaultyScene::camera() const {
    render::Camera camera;
    if (!bounds_.empty()) {
        camera.target = bounds_.center();
        camera.eye = camera.target + Vec3(3, 2, 4);
        camera.frame(bounds_);
    }
    return camera;
}

}  // namespace kerf::app
