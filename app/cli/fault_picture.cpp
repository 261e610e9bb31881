#include "app/cli/fault_picture.h"

#include "app/scene/document/faulty_scene.h"
#include "render/renderer.h"
#include "render/scene/paste.h"
#include "ui/state/fault_legend.h"

namespace kerf::app {
namespace {

constexpr int kMargin = 12;  // around the legend [px]

}  // namespace

render::Image faultPicture(const FoundFaults& found, const std::filesystem::path& file,
                           const std::string& title, const PictureSize& size) {
    const FaultyScene scene(found, file);
    render::Renderer renderer(render::Quality::full);
    renderer.draw(scene.view(), scene.camera(), size.width, size.height);
    render::Image picture = renderer.readPicture();
    render::paste(picture, ui::drawFaultLegend(title, ui::faultRows(scene.marks())), kMargin,
                  kMargin);
    return picture;
}

}  // namespace kerf::app
