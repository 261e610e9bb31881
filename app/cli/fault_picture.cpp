#include "app/cli/fault_picture.h"

#include <algorithm>
#include <cstddef>

#include "app/scene/faulty_scene.h"
#include "render/renderer.h"
#include "ui/fault_legend.h"

namespace kerf::app {
namespace {

constexpr int kMargin = 12;  // around the legend [px]

/// What has no room is left out.
void copyInto(render::Image& picture, const render::Image& part, int left, int top) {
    const int width = std::min(part.width, picture.width - left);
    const int height = std::min(part.height, picture.height - top);
    for (int y = 0; y < height && width > 0; ++y) {
        const auto from = part.pixels.begin() + std::ptrdiff_t(4) * y * part.width;
        const auto to = picture.pixels.begin() +
                        std::ptrdiff_t(4) * ((std::ptrdiff_t(top) + y) * picture.width + left);
        std::copy(from, from + std::ptrdiff_t(4) * width, to);
    }
}

}  // namespace

render::Image faultPicture(const FoundFaults& found, const std::filesystem::path& file,
                           const std::string& title, const PictureSize& size) {
    const FaultyScene scene(found, file);
    render::Renderer renderer(render::Quality::full);
    renderer.draw(scene.view(), scene.camera(), size.width, size.height);
    render::Image picture = renderer.readPicture();
    copyInto(picture, ui::drawFaultLegend(title, ui::faultRows(scene.marks())), kMargin, kMargin);
    return picture;
}

}  // namespace kerf::app
