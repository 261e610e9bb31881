#include <algorithm>

#include "app/editor/editor_state.h"
#include "sim/base/text.h"
#include "ui/action_table.h"

namespace kerf::app {
namespace {

constexpr int kMaxBatchesPerPicture = 16;

bool pressesKey(const std::vector<ui::InputEvent>& batch) {
    return std::ranges::any_of(batch, [](const ui::InputEvent& event) {
        const auto* key = std::get_if<ui::KeyChange>(&event);
        return key != nullptr && key->down;
    });
}

}  // namespace

void Editor::State::takeInput(double elapsedSeconds) {
    if (const BusyScene now = scene.meanwhile(); now && !now.playing()) {
        now.stroke().elapse(elapsedSeconds);
    }
    // At least one update, so that the panels live; later batches of one picture take no time.
    for (int n = 1; n <= kMaxBatchesPerPicture && (n == 1 || !queue.empty()); ++n) {
        const std::vector<ui::InputEvent> batch = queue.takeBatch();
        if (!batch.empty()) {
            kernels.interrupt();
        }
        const bool last = n == kMaxBatchesPerPicture || queue.empty();
        if (panels.interface.ownsKeyboard() && pressesKey(batch)) {
            updatePanels({}, 0, false);  // What the last key closed has the keyboard no longer.
        }
        updatePanels(batch, n == 1 ? elapsedSeconds : 0, last);
    }
}

void Editor::State::updatePanels(const std::vector<ui::InputEvent>& batch, double elapsedSeconds,
                                 bool last) {
    describe(last);
    const std::vector<ui::Action> actions =
        panels.update(batch, view.width, view.height, elapsedSeconds);
    view.free = panels.interface.freeView();
    view.bright = panels.settings.now.theme == ui::Theme::light;
    view.mouse = panels.settings.now.mouse;
    redraw.countUpdate(batch.empty() && actions.empty());
    for (const ui::InputEvent& event : batch) {
        dispatch(event);
    }
    for (const ui::Action& action : actions) {
        apply(action);
    }
}

void Editor::State::dispatch(const ui::InputEvent& event) {
    if (const auto* move = std::get_if<ui::PointerMove>(&event)) {
        view.move(*move, sceneInHand());
    } else if (const auto* change = std::get_if<ui::ButtonChange>(&event)) {
        onButton(*change);
    } else if (const auto* wheel = std::get_if<ui::Wheel>(&event);
               wheel != nullptr && pointsAtView()) {
        view.zoom(wheel->y, faulty ? BusyScene{} : scene.meanwhile());
    } else if (const auto* key = std::get_if<ui::KeyChange>(&event); key != nullptr && key->down) {
        onKey(key->key, key->modifiers);
    } else if (const auto* typed = std::get_if<ui::Character>(&event);
               typed && typed->code == '?') {
        onKey(ui::Key::questionMark, {});
    } else if (const auto* drop = std::get_if<ui::FileDrop>(&event); drop && !drop->files.empty()) {
        if (drop->files.size() > 1) {
            toast.show(
                "Of " + counted(drop->files.size(), "file", "files") + " the first is opened.",
                false);
        }
        openAsked(drop->files.front());
    } else if (std::holds_alternative<ui::FocusLost>(event)) {
        view.camera.releaseAll();
        onButton({ui::Button::left, false, {}});
    }
}

void Editor::State::onButton(const ui::ButtonChange& change) {
    if (!change.down) {
        const bool clicks = change.button == ui::Button::right && view.rightClicks();
        say(view.release(change.button, sceneInHand(clicks)));
    } else if (pointsAtView()) {
        say(view.press(change, sceneInHand(true)));
    }
}

void Editor::State::onKey(ui::Key key, const ui::Modifiers& modifiers) {
    if (panels.interface.ownsKeyboard()) {
        return;
    }
    if (const std::optional<ui::ActionId> id = ui::findAction(key, modifiers)) {
        apply(*id);
    }
}

/// Beside a question about it, the view can still be turned.
bool Editor::State::pointsAtView() const {
    return !panels.interface.ownsPointer() || panels.interface.pointsBesideQuestion();
}

BusyScene Editor::State::sceneInHand(bool presses) {
    if (faulty || (presses && comesBack())) {
        return {};
    }
    if (ui::rowOf(view.tools.settings().tool).readsBody && (presses || view.holds())) {
        scene.get();
    }
    return scene.meanwhile();
}

}  // namespace kerf::app
