#include "app/editor/editor_state.h"
#include "app/scene/held_hands.h"
#include "ui/state/action_table.h"

namespace kerf::app {
namespace {

using State = Editor::State;

constexpr int kMaxBatchesPerPicture = 16;

bool pressesKey(const std::vector<ui::InputEvent>& batch) {
    return std::ranges::any_of(batch, [](const ui::InputEvent& event) {
        const auto* key = std::get_if<ui::KeyChange>(&event);
        return key != nullptr && key->down;
    });
}

/// Beside a question about it, the view can still be turned.
bool pointsAtView(const State& s) {
    return !s.panels.interface.ownsPointer() || s.panels.interface.pointsBesideQuestion();
}

/// The scene for the current tool: one that moves the blade doesn't wait.
BusyScene sceneInHand(State& s, bool presses = false) {
    const ui::ToolRow& tool = ui::rowOf(s.view.tools.settings().tool);
    const bool waits = s.comesBack() || (tool.leadsBlade && s.link.leads(s.scene.meanwhile()));
    if (s.view.faulty || (presses && waits)) {
        return {};
    }
    if (tool.readsBody && (presses || s.view.holds())) {
        s.scene.get();
    }
    return s.scene.meanwhile();
}

/// In a dialog only the window can be closed, as by its button.
void onKey(State& s, ui::Key key, const ui::Modifiers& modifiers) {
    const std::optional<ui::ActionId> id = ui::findAction(key, modifiers);
    const bool taken = s.panels.interface.ownsKeyboard() || s.panels.interface.ownsKey(key);
    if (id && (!taken || *id == ui::ActionId::quit)) {
        s.apply(*id);
    }
}

void onButton(State& s, const ui::ButtonChange& change) {
    if (!change.down) {
        const bool clicks = change.button == ui::Button::right && s.view.rightClicks();
        s.say(s.view.release(change.button, sceneInHand(s, clicks)));
    } else if (pointsAtView(s)) {
        s.say(s.view.press(change, sceneInHand(s, true)));
    }
}

void openDropped(State& s, const DroppedFiles& dropped) {
    if (dropped.files.size() == 1) {
        s.openAsked(dropped.files.front(), dropped.remark);
        return;
    }
    OpeningOrder order = orderOf(dropped.files);
    order.remark = dropped.remark;
    s.askBefore("Open " + std::to_string(dropped.files.size()) + " models",
                [&s, order] { s.open(order); });
}

void dispatch(State& s, const ui::InputEvent& event) {
    if (const auto* move = std::get_if<ui::PointerMove>(&event)) {
        s.view.move(*move, sceneInHand(s));
    } else if (const auto* change = std::get_if<ui::ButtonChange>(&event)) {
        onButton(s, *change);
    } else if (const auto* wheel = std::get_if<ui::Wheel>(&event);
               wheel != nullptr && pointsAtView(s)) {
        s.view.turnWheel(wheel->y, s.view.faulty ? BusyScene{} : s.scene.meanwhile());
    } else if (const auto* key = std::get_if<ui::KeyChange>(&event); key != nullptr && key->down) {
        onKey(s, key->key, key->modifiers);
    } else if (const auto* typed = std::get_if<ui::Character>(&event);
               typed && typed->code == '?') {
        onKey(s, ui::Key::questionMark, {});
    } else if (const auto* drop = std::get_if<ui::FileDrop>(&event); drop && !drop->files.empty()) {
        openDropped(s, sortDropped(drop->files));
    } else if (std::holds_alternative<ui::FocusLost>(event)) {
        s.view.camera.releaseAll();
        onButton(s, {ui::Button::left, false, {}});
    }
}

/// Updates the panels with a batch and carries out their actions. `last`: the last one of this
/// frame.
void updatePanels(State& s, const std::vector<ui::InputEvent>& batch, double elapsedSeconds,
                  bool last) {
    s.describe(last);
    const std::vector<ui::Action> actions =
        s.panels.update(batch, s.view.width, s.view.height, elapsedSeconds);
    const bool first = s.view.free.width == 0;
    s.view.free = s.panels.interface.freeView();
    if (first && s.scene != nullptr && !s.scene.meanwhile().document().session.editor) {
        s.view.camera = EditorCamera(s.view.homeView(s.scene.meanwhile()));
    }
    s.view.hint = s.panels.interface.hintHeight();
    s.view.bright = s.panels.settings.now.theme == ui::Theme::light;
    s.view.mouse = s.panels.settings.now.mouse;
    s.redraw.countUpdate(batch.empty() && actions.empty());
    for (const ui::InputEvent& event : batch) {
        dispatch(s, event);
    }
    for (const ui::Action& action : actions) {
        s.apply(action);
    }
}

}  // namespace

void Editor::State::takeInput(double elapsedSeconds) {
    if (const BusyScene now = scene.meanwhile()) {
        const bool practises = now.document().session.task.has_value();
        now.stroke().keepTime(practises ? now.timeStep() : 0);
        now.stroke().elapse(practises || !now.playing() ? elapsedSeconds : 0);
        const bool runs =
            now.pulling() || now.playing() || panels.settings.now.timeRunsWhileCutting;
        now.stroke().limitStep(runs && !practises && clock.byTheClock()
                                   ? HeldHands::usualSpeed(now.diagonal()) * now.timeStep()
                                   : std::numeric_limits<double>::infinity());
    }
    // At least one update, so that the panels live; later batches of one picture take no time.
    for (int n = 1; n <= kMaxBatchesPerPicture && (n == 1 || !queue.empty()); ++n) {
        const std::vector<ui::InputEvent> batch = queue.takeBatch();
        const bool last = n == kMaxBatchesPerPicture || queue.empty();
        if (panels.interface.ownsKeyboard() && pressesKey(batch)) {
            updatePanels(*this, {}, 0,
                         false);  // What the last key closed has the keyboard no longer.
        }
        updatePanels(*this, batch, n == 1 ? elapsedSeconds : 0, last);
    }
}

}  // namespace kerf::app
