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
    // At least one update, so that the panels live; later batches of one picture take no time.
    for (int n = 1; n <= kMaxBatchesPerPicture && (n == 1 || !queue.empty()); ++n) {
        const std::vector<ui::InputEvent> batch = queue.takeBatch();
        const bool last = n == kMaxBatchesPerPicture || queue.empty();
        if (interface.ownsKeyboard() && pressesKey(batch)) {
            updatePanels({}, 0, false);  // What the last key closed has the keyboard no longer.
        }
        updatePanels(batch, n == 1 ? elapsedSeconds : 0, last);
    }
}

void Editor::State::updatePanels(const std::vector<ui::InputEvent>& batch, double elapsedSeconds,
                                 bool last) {
    describe(last);
    settleUpdates = batch.empty() ? std::max(0, settleUpdates - 1) : kSettleUpdates;
    interface.restyle(settingsFile.now.theme, scale());
    const std::vector<ui::Action> actions =
        interface.update(batch, model, options.width, options.height, elapsedSeconds);
    for (const ui::InputEvent& event : batch) {
        dispatch(event);
    }
    for (const ui::Action& action : actions) {
        apply(action);
    }
}

void Editor::State::dispatch(const ui::InputEvent& event) {
    if (const auto* move = std::get_if<ui::PointerMove>(&event)) {
        onMove(*move);
    } else if (const auto* change = std::get_if<ui::ButtonChange>(&event)) {
        onButton(*change);
    } else if (const auto* wheel = std::get_if<ui::Wheel>(&event)) {
        onWheel(*wheel);
    } else if (const auto* key = std::get_if<ui::KeyChange>(&event); key != nullptr && key->down) {
        onKey(key->key, key->modifiers);
    } else if (const auto* typed = std::get_if<ui::Character>(&event);
               typed && typed->code == '?') {
        onKey(ui::Key::questionMark, {});
    } else if (const auto* drop = std::get_if<ui::FileDrop>(&event); drop && !drop->files.empty()) {
        takeDrop(drop->files);
    } else if (std::holds_alternative<ui::FocusLost>(event)) {
        onFocusLost();
    }
}

void Editor::State::takeDrop(const std::vector<std::filesystem::path>& files) {
    if (files.size() > 1) {
        toast.show("Of " + counted(files.size(), "file", "files") + " the first is opened.", false);
    }
    open(files.front());
}

void Editor::State::onMove(const ui::PointerMove& move) {
    const Vec2 to{move.x, move.y};
    const Vec2 by = to - pointer;
    pointer = to;
    if (cameraControl.move(camera, by.x(), by.y(), options.height)) {
        keepCameraNear();
    }
    if (scene != nullptr) {
        bladeTool.move(viewFrame(), pointer, move.modifiers.shift, *scene);
        pullTool.move(viewFrame(), pointer, *scene);
    }
}

void Editor::State::onButton(const ui::ButtonChange& change) {
    if (!change.down) {
        cameraControl.release(change.button);
        if (change.button == ui::Button::left) {
            endStroke();
        }
        return;
    }
    if (interface.ownsPointer() || bladeTool.holds() || pullTool.holds()) {
        return;
    }
    landCamera();
    if (cameraControl.press(change)) {
        return;
    }
    if (change.button == ui::Button::left && scene != nullptr) {
        pressInScene(change.modifiers);
    }
}

void Editor::State::pressInScene(const ui::Modifiers& modifiers) {
    const ui::ToolSettings& settings = bladeTool.settings();
    if (joinPieces() && settings.tool != ui::Tool::stroke) {
        return;  // What was aimed at is elsewhere.
    }
    bladeTool.press(viewFrame(), pointer, *scene);
    if (settings.tool == ui::Tool::grab || settings.tool == ui::Tool::pin) {
        say(pullTool.press(viewFrame(), pointer, settings, modifiers, *scene));
    }
}

void Editor::State::endStroke() {
    if (scene != nullptr && bladeTool.holds()) {
        bladeTool.release(*scene);
    }
    if (scene != nullptr && pullTool.holds()) {
        say(pullTool.release(viewFrame(), *scene));
    }
}

void Editor::State::keepCameraNear() {
    sceneChanged = true;
    if (scene != nullptr) {
        keepNear(camera, scene->bounds());
    }
}

void Editor::State::onWheel(const ui::Wheel& wheel) {
    if (!interface.ownsPointer()) {
        landCamera();
        const ViewFrame view = viewFrame();
        CameraControl::zoom(camera, wheel.y, view.toNdc(pointer), view.aspect());
        keepCameraNear();
    }
}

void Editor::State::onKey(ui::Key key, const ui::Modifiers& modifiers) {
    if (interface.ownsKeyboard()) {
        return;
    }
    if (const std::optional<ui::ActionId> id = ui::findAction(key, modifiers)) {
        perform(*id);
    }
}

void Editor::State::onFocusLost() {
    cameraControl.releaseAll();
    endStroke();
}

}  // namespace kerf::app
