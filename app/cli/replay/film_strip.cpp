#include "app/cli/replay/film_strip.h"

#include <spdlog/fmt/fmt.h>

namespace kerf::app {
namespace {

constexpr int kWidestStrip = 16384;  // [px]
// Strips are shown smaller than they are, so text and margins grow with their pictures.
constexpr double kUsualPictureHeight = 200;  // at which text is as high as in the window [px]
constexpr double kLeastStripTextScale = 0.8;
constexpr double kStripMargin = 10;  // at most, at that height [px]

double stripTextScale(const PictureSize& size) {
    return std::max(kLeastStripTextScale, size.height / kUsualPictureHeight);
}

}  // namespace

int mostStripPictures(const PictureSize& size) {
    const double margin = std::ceil(kStripMargin * stripTextScale(size));
    return static_cast<int>((kWidestStrip - margin) / (size.width + margin));
}

FilmStrip::FilmStrip(const StripOptions& options, int steps)
    : options_(options), steps_(steps), file_(options.file) {}

int FilmStrip::nextStep() const {
    const double share = static_cast<double>(pictures_.size()) / (options_.pictures - 1);
    return static_cast<int>(std::lround(share * steps_));
}

void FilmStrip::show(int step, double time, const render::Camera& camera, const Film::Draw& draw) {
    const auto count = static_cast<std::size_t>(options_.pictures);
    while (pictures_.size() < count && nextStep() == step) {
        pictures_.push_back(
            {draw(camera, options_.size), fmt::format("step {}, {:.2f} s", step, time)});
    }
}

void FilmStrip::finish(const std::string& title) {
    if (pictures_.empty()) {
        return;  // a check failed before the first step
    }
    ui::PicturePainter painter(ui::Theme::light, static_cast<float>(stripTextScale(options_.size)));
    const std::vector<std::uint8_t> bytes =
        render::encodePng(ui::drawStrip(painter, title, pictures_));
    file_.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    file_.commit();
}

}  // namespace kerf::app
