#include "app/cli/replay/film.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "render/scene/image.h"
#include "ui/base/caption.h"

namespace kerf::app {
namespace {

constexpr double kRounding = 1e-9;    // of sums of time steps
constexpr double kUsualHeight = 540;  // at which text is as high as in the window [px]
constexpr double kLeastTextScale = 0.6;
constexpr double kCaptionMargin = 12;  // of a caption at that height [px]

double textScale(const PictureSize& size) {
    return std::max(kLeastTextScale, size.height / kUsualHeight);
}

int rateOf(const FilmOptions& options) {
    return options.rate > 0 ? options.rate : filmFormatOf(options.file)->rate;
}

}  // namespace

void FilmClock::pass(double seconds) {
    lastStep_ = seconds;
    elapsed_ += seconds;
}

std::optional<double> FilmClock::takeFrame() {
    const double moment = frames_ * secondsPerFrame_;
    const double before = elapsed_ - moment;
    if (before < -kRounding * std::max(elapsed_, lastStep_)) {
        return std::nullopt;
    }
    ++frames_;
    return lastStep_ > 0 ? std::clamp(before / lastStep_, 0.0, 1.0) : 0;
}

Film::Film(const FilmOptions& options, const std::filesystem::path& unfinished, int steps,
           render::CameraPath path)
    : options_(options),
      rate_(rateOf(options)),
      steps_(steps),
      path_(std::move(path)),
      clock_(options.speed / rate_),
      encoder_(options.file, unfinished, options.size.width, options.size.height, rate_),
      captions_(options.speed) {
    if (options.captions) {
        painter_.emplace(ui::Theme::dark, static_cast<float>(textScale(options.size)));
    }
}

void Film::note(const Command& command) {
    if (const auto* move = std::get_if<MoveBlade>(&command)) {
        handSeconds_ = move->seconds;
    }
    captions_.note(command, filmTime());
}

void Film::pass(double timeStep, bool timeRuns) {
    const auto hand = std::exchange(handSeconds_, std::nullopt);
    clock_.pass(timeRuns ? timeStep : hand.value_or(timeStep));
}

void Film::show(int step, double time, const render::Camera& camera, const Draw& draw) {
    std::optional<render::Image> picture;
    while (const std::optional<double> before = clock_.takeFrame()) {
        if (!picture || options_.turntable || !path_.empty()) {
            picture = draw(cameraAt(step - *before, camera), options_.size);
            caption(*picture, time);
        }
        encoder_.add(*picture);
    }
}

render::Camera Film::cameraAt(double moment, const render::Camera& camera) const {
    render::Camera seen = path_.empty() ? camera : path_.at(moment);
    if (options_.turntable) {
        seen.orbit(2 * std::numbers::pi * moment / steps_, 0);
    }
    return seen;
}

void Film::caption(render::Image& picture, double time) {
    if (painter_) {
        const int margin = static_cast<int>(kCaptionMargin * textScale(options_.size));
        const render::Image text = ui::drawCaption(*painter_, captions_.at(filmTime(), time));
        render::paste(picture, text, margin, picture.height - margin - text.height);
    }
}

FilmReport Film::finish() {
    encoder_.finish();
    return {clock_.frames(), static_cast<double>(clock_.frames()) / rate_};
}

}  // namespace kerf::app
