#include "bench/lab/fem/fem_pictures.h"

#include <array>
#include <map>
#include <memory>
#include <utility>

#include "render/renderer.h"
#include "render/scene/camera.h"
#include "render/soup_body.h"
#include "sim/mesh/triangle.h"
#include "ui/plots/picture_strip.h"

namespace kerf::app {

namespace {

constexpr int kWidth = 640;     // of a picture [px]
constexpr int kHeight = 420;    // [px]
constexpr float kScale = 1.8F;  // strips are shown at half of their size
constexpr render::DisplayColor kElementColor{0, 114, 178};
constexpr double kSharp = 0.5;  ///< cosine of the angle between faces from which on they are edged
constexpr render::DisplayColor kRimColor{213, 94, 0};

Bounds boundsOf(const LoadedSurface& surface) {
    Bounds bounds;
    for (const Triangle& t : surface.triangles) {
        for (const int v : t) {
            bounds.add(surface.positions[v]);
        }
    }
    return bounds;
}

/// From the front right above; the bodies fill the view.
render::Camera cameraOn(const Bounds& bounds) {
    render::Camera camera;
    camera.target = bounds.center();
    camera.eye = camera.target + Vec3(1.5, 1.2, 4);
    camera.frame(bounds, 1.15);
    return camera;
}

/// The triangles of a body, with those of another one as points alone.
TriangleSoup soupOf(const LoadedSurface& body, const LoadedSurface& points) {
    TriangleSoup soup{body.positions, body.triangles, {}};
    soup.positions.insert(soup.positions.end(), points.positions.begin(), points.positions.end());
    return soup;
}

using Edges = std::map<std::pair<int, int>, std::vector<std::size_t>>;

/// The triangles at each edge of a surface.
Edges trianglesAtEdges(const LoadedSurface& surface) {
    Edges edges;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const Triangle& corners = surface.triangles[t];
        for (int i = 0; i < 3; ++i) {
            edges[std::minmax({corners[i], corners[(i + 1) % 3]})].push_back(t);
        }
    }
    return edges;
}

/// The ends of all edges for which wanted(triangles at the edge) holds, whose points stand from
/// `first` on.
template <class Wanted>
std::vector<std::uint32_t> edgesOf(const LoadedSurface& surface, std::size_t first,
                                   Wanted&& wanted) {
    std::vector<std::uint32_t> lines;
    for (const auto& [ends, triangles] : trianglesAtEdges(surface)) {
        if (wanted(triangles)) {
            lines.push_back(static_cast<std::uint32_t>(first + ends.first));
            lines.push_back(static_cast<std::uint32_t>(first + ends.second));
        }
    }
    return lines;
}

/// The edges between skin and walls.
std::vector<std::uint32_t> rimOf(const LoadedSurface& surface) {
    return edgesOf(surface, 0, [&](const std::vector<std::size_t>& triangles) {
        return triangles.size() == 2 && surface.walls[triangles[0]] != surface.walls[triangles[1]];
    });
}

/// The edges of the body at rest; all where it is round.
std::vector<std::uint32_t> outlineOf(const LoadedSurface& surface, std::size_t first) {
    const auto normalAtRest = [&](std::size_t t) {
        const auto& [a, b, c] = surface.triangles[t];
        return unitNormal(surface.rest[a], surface.rest[b], surface.rest[c]);
    };
    const std::vector<std::uint32_t> sharp =
        edgesOf(surface, first, [&](const std::vector<std::size_t>& triangles) {
            return triangles.size() == 2 &&
                   normalAtRest(triangles[0]).dot(normalAtRest(triangles[1])) < kSharp;
        });
    return sharp.empty() ? edgesOf(surface, first, [](const auto&) { return true; }) : sharp;
}

/// Draws the bodies of one strip.
class StripArtist {
  public:
    explicit StripArtist(const Bounds& bounds)
        : bounds_(bounds), camera_(cameraOn(bounds)), renderer_(render::Quality::full) {}

    render::Image draw(const LoadedSurface& body, const LoadedSurface& over, bool showsOver) {
        const render::SoupBody soup(soupOf(body, over));
        render::SceneView view;
        view.body = soup.view();
        view.look = render::rowOf(render::LookName::jelly).look;
        view.restBounds = bounds_;
        view.focus = bounds_;
        view.bright = true;
        std::vector<render::Marks> marks;
        marks.push_back({"", kRimColor, rimOf(body), {}});
        if (showsOver) {
            marks.push_back({"", kElementColor, outlineOf(over, body.positions.size()), {}});
        }
        view.marks = std::make_shared<const std::vector<render::Marks>>(std::move(marks));
        renderer_.draw(view, camera_, kWidth, kHeight);
        return renderer_.readPicture();
    }

  private:
    Bounds bounds_;
    render::Camera camera_;
    render::Renderer renderer_;
};

}  // namespace

render::Image drawBesideEachOther(const std::string& title, const LoadedSurface& kerf,
                                  const LoadedSurface& elements) {
    Bounds bounds = boundsOf(kerf);
    bounds.add(boundsOf(elements));
    StripArtist artist(bounds);
    const std::array pictures{
        ui::StripPicture{artist.draw(kerf, elements, false), "Kerf"},
        ui::StripPicture{artist.draw(elements, kerf, false), "finite elements"},
        ui::StripPicture{artist.draw(kerf, elements, true), "Kerf, and lines of finite elements"}};
    ui::PicturePainter painter(ui::Theme::light, kScale);
    return ui::drawStrip(painter, title, pictures);
}

}  // namespace kerf::app
