#include "app/editor/view/editor_toast.h"

#include "ui/state/action_table.h"

namespace kerf::app {
namespace {

constexpr double kNoticeSeconds = 5;
constexpr double kOfferSeconds = 10;
constexpr double kErrorSeconds = 12;
constexpr double kFadeSeconds = 0.5;
constexpr std::size_t kMostLogLines = 200;

}  // namespace

void EditorToast::show(std::string text, bool isError) {
    text_ = std::move(text);
    isError_ = isError;
    choice_.reset();
    if (log_.size() == kMostLogLines) {
        log_.erase(log_.begin());
    }
    log_.push_back({text_, isError});
    remaining_ = isError ? kErrorSeconds : kNoticeSeconds;
}

void EditorToast::offer(std::string text, ui::HintChoice choice) {
    show(std::move(text), false);
    choice_ = std::move(choice);
    remaining_ = kOfferSeconds;
}

void EditorToast::show(const SavingQueue::Outcome& outcome) {
    show(outcome.sentence, outcome.failed);
    if (offer_ && offer_->saving == outcome.number && !outcome.failed) {
        choice_ = {ui::ActionId::addPicture, "Add to session"};
        remaining_ = kOfferSeconds;
    }
}

std::optional<LogPosition> EditorToast::takeOffer() {
    const std::optional<Offer> offer = std::exchange(offer_, std::nullopt);
    const bool shown = choice_ && choice_->id == ui::ActionId::addPicture && visible();
    return offer && shown ? std::optional(offer->place) : std::nullopt;
}

void EditorToast::elapse(double elapsedSeconds) {
    remaining_ = std::max(0.0, remaining_ - elapsedSeconds);
}

double EditorToast::steadySeconds() const {
    return std::max(0.0, remaining_ - kFadeSeconds);
}

void EditorToast::describe(ui::PanelModel& model) const {
    model.toast.text = visible() ? text_ : "";
    model.toast.choice = visible() ? choice_ : std::nullopt;
    model.log = log_;
    model.toast.isError = isError_;
    model.toast.opacity = static_cast<float>(std::min(1.0, remaining_ / kFadeSeconds));
}

}  // namespace kerf::app
