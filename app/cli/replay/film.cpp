#include "app/cli/replay/film.h"

#include <spdlog/fmt/fmt.h>

#include "app/session/session.h"
#include "render/scene/image.h"
#include "sim/run/undo/undo_history.h"
#include "ui/base/unit_text.h"

namespace kerf::app {

namespace {

constexpr double kToldFor = 2.5;  // of the film [s]

/// What an action is called; "" for one that nobody is told of.
struct NameOf {
    std::string operator()(const SetParam& set) const {
        if (!set.material.empty()) {
            return "Material: " + set.material;
        }
        return ui::withRaisedDigits(nameOfChange(set.name, set.value));
    }
    std::string operator()(const Grab&) const { return "A hand takes hold"; }
    std::string operator()(const Release&) const { return "The hand lets go"; }
    std::string operator()(const Pin& pin) const {
        return pin.velocity ? "Moved" : (pin.pinned ? "Pinned" : "Pins freed");
    }
    std::string operator()(const ApplyForce& apply) const {
        return apply.newtons == Vec3::Zero() ? "Force removed" : "A force acts";
    }
    std::string operator()(const MovePins&) const { return "Pins moved"; }
    std::string operator()(const AddBox&) const { return "A box is put up"; }
    std::string operator()(const ChangeBox&) const { return "The box is moved"; }
    std::string operator()(const RemoveBox&) const { return "The box is taken away"; }
    std::string operator()(const RemovePiece&) const { return "A piece is taken away"; }
    std::string operator()(const Restart&) const { return "The whole body again"; }
    std::string operator()(const Place&) const { return "Placed otherwise"; }
    std::string operator()(const Undo&) const { return "Undo"; }
    std::string operator()(const Redo&) const { return "Redo"; }
    std::string operator()(const SetTime& time) const {
        return time.runs ? "Time runs" : "Time stands";
    }
    template <class Other>
    std::string operator()(const Other&) const {
        return "";
    }
};

std::string paceOf(double speed) {
    if (speed == 1) {
        return "";
    }
    return speed < 1 ? fmt::format(", {:.4g} times slower", 1 / speed)
                     : fmt::format(", {:.4g} times faster", speed);
}

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

FilmCaptions::FilmCaptions(double speed) : pace_(paceOf(speed)) {}

void FilmCaptions::note(const Command& command, double filmTime) {
    if (std::holds_alternative<MoveBlade>(command)) {
        if (!std::exchange(bladeIsDown_, true)) {
            tell(fmt::format("Cut {}", ++cuts_), filmTime);
        }
        return;
    }
    const auto widen = [](const auto& action) { return SessionAction(action); };
    if (takesBladeAway(std::visit(widen, command)) && std::exchange(bladeIsDown_, false)) {
        since_ = filmTime;  // what was told of the cut stays for a while
    }
    if (std::string name = std::visit(NameOf{}, command); !name.empty()) {
        tell(std::move(name), filmTime);
    }
}

void FilmCaptions::tell(std::string words, double filmTime) {
    words_ = std::move(words);
    since_ = filmTime;
}

std::string FilmCaptions::at(double filmTime, double time) const {
    const bool told = bladeIsDown_ || filmTime - since_ < kToldFor;
    const bool speaks = told && !words_.empty();
    return fmt::format("{:.2f} s{}{}{}", time, pace_, speaks ? ". " : "", speaks ? words_ : "");
}

void FilmClock::note(const Command& command) {
    if (const auto* move = std::get_if<MoveBlade>(&command)) {
        handSeconds_ = move->seconds;
    }
}

void FilmClock::pass(double timeStep, bool timeRuns) {
    const auto hand = std::exchange(handSeconds_, std::nullopt);
    lastStep_ = timeRuns ? timeStep : hand.value_or(timeStep);
    elapsed_ += lastStep_;
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
    clock_.note(command);
    captions_.note(command, filmTime());
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
