#include "app/cli/replay/film_captions.h"

#include <spdlog/fmt/fmt.h>

#include <utility>
#include <variant>

#include "app/session/session.h"
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

}  // namespace kerf::app
