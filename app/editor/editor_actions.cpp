#include "app/editor/editor_state.h"
#include "app/tools/box_placement.h"

namespace kerf::app {
namespace {

const Vec3 kEarthGravity{0, -9.81, 0};

}  // namespace

void Editor::State::apply(const ui::Action& action) {
    if (const auto* id = std::get_if<ui::ActionId>(&action)) {
        perform(*id);
    } else if (const auto* change = std::get_if<ui::GoToChange>(&action)) {
        goToChange(change->done);
    } else if (const auto* speed = std::get_if<ui::SetSpeed>(&action)) {
        clock.setSpeed(speed->factor);
    } else if (const auto* seek = std::get_if<ui::SeekTo>(&action)) {
        seekTo(seek->step);
    } else if (const auto* blade = std::get_if<ui::SetTools>(&action)) {
        setTools(blade->settings);
    } else if (std::holds_alternative<ui::PlaceBox>(action)) {
        placeBox();
    } else if (const auto* moved = std::get_if<ChangeBox>(&action)) {
        execute(*moved);
    } else if (const auto* removed = std::get_if<RemoveBox>(&action)) {
        execute(*removed);
    } else if (std::holds_alternative<ui::CancelWork>(action)) {
        cancelWork();
    } else if (const auto* answered = std::get_if<ui::AnswerQuestion>(&action)) {
        answer(answered->choice);
    } else if (const auto* file = std::get_if<ui::FileAction>(&action)) {
        applyToFiles(*file);
    } else if (const auto* shown = std::get_if<ui::SetDisplay>(&action)) {
        setDisplay(shown->settings);
    } else if (const auto* set = std::get_if<SetParam>(&action)) {
        execute(*set);
    } else {
        applyToPanels(action);
    }
}

void Editor::State::placeBox() {
    if (scene != nullptr) {
        execute(AddBox{boxBeside(scene->bounds(), scene->simulation().params().floor)});
    }
}

/// Before the body goes elsewhere: neither a stroke nor a pull goes on there.
void Editor::State::releaseHands() {
    hand.cancel(*scene);
    bodyHand.cancel(*scene);
}

bool Editor::State::execute(const Command& command) {
    if (scene == nullptr) {
        return false;
    }
    if (std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command)) {
        releaseHands();
    }
    const std::string problem = scene->execute(command);
    say(problem);
    return problem.empty();
}

void Editor::State::say(const std::string& problem) {
    if (!problem.empty()) {
        toast.show(problem, true);
    }
    sceneChanged = true;
    settlePasses = kSettlePasses;
}

void Editor::State::seekTo(int step) {
    if (scene != nullptr) {
        scene->seek(step);
        sceneChanged = true;
        settlePasses = kSettlePasses;
    }
}

void Editor::State::setTools(const ui::ToolSettings& settings) {
    if (scene != nullptr) {
        if (settings.tool != hand.settings().tool) {
            joinPieces();
            bodyHand.cancel(*scene);
        }
        hand.set(settings, *scene);
        settlePasses = kSettlePasses;
    }
}

void Editor::State::setTool(ui::Tool tool) {
    ui::ToolSettings settings = hand.settings();
    settings.tool = tool;
    setTools(settings);
}

void Editor::State::toggleRecording() {
    if (!scene->recording()) {
        releaseHands();
        scene->startRecording();
        toast.show("Recording. Ctrl+R stops it and saves a session.", false);
        return;
    }
    scene->stopRecording();
    saveRecording();
}

/// Says which parameter that changed: many show in the model only later.
void Editor::State::stepThroughHistory(const Command& undoOrRedo) {
    if (!execute(undoOrRedo)) {
        return;
    }
    const UndoHistory& history = scene->simulation().history();
    const bool back = std::holds_alternative<Undo>(undoOrRedo);
    if (back ? !history.canRedo() : !history.canUndo()) {
        return;  // it was forgotten to keep to the budget
    }
    const UndoEntry& entry = back ? history.firstUndone() : history.lastDone();
    if (std::holds_alternative<UndoEntry::ParamChange>(entry.change)) {
        toast.show((back ? "Taken back: " : "Done again: ") + entry.name + ".", false);
    }
}

void Editor::State::goToChange(std::size_t done) {
    if (scene == nullptr) {
        return;
    }
    const UndoHistory& history = scene->simulation().history();
    while (history.done() > done && history.canUndo()) {
        execute(Undo{});
    }
    while (history.done() < done && history.canRedo()) {
        execute(Redo{});
    }
}

void Editor::State::perform(ui::ActionId id) {
    settlePasses = kSettlePasses;
    switch (id) {
        case ui::ActionId::help:
            helpOpen = !helpOpen;
            return;
        case ui::ActionId::openFile:
            browse(ui::FilePurpose::open);
            return;
        case ui::ActionId::screenshot:
            screenshotWanted = true;
            return;
        case ui::ActionId::cancel:
            cancel();
            return;
        case ui::ActionId::togglePanels:
            togglePanels();
            return;
        case ui::ActionId::holdPlots:
            holdPlots();
            return;
        case ui::ActionId::fitPlots:
            plotView = {};
            return;
        case ui::ActionId::quit:
            closing = true;
            return;
        default:
            if (scene != nullptr) {
                performOnScene(id);
                sceneChanged = true;
            }
    }
}

void Editor::State::performOnScene(ui::ActionId id) {
    switch (id) {
        case ui::ActionId::playPause:
            scene->playing = !scene->playing;
            return;
        case ui::ActionId::stepOnce:
            scene->playing = false;
            runSteps(1, 0);
            return;
        case ui::ActionId::reset:
            releaseHands();
            scene->reset();
            return;
        case ui::ActionId::undo:
            stepThroughHistory(Undo{});
            return;
        case ui::ActionId::redo:
            stepThroughHistory(Redo{});
            return;
        case ui::ActionId::toolStroke:
            setTool(ui::Tool::stroke);
            return;
        case ui::ActionId::toolScalpel:
            setTool(ui::Tool::scalpel);
            return;
        case ui::ActionId::toolGuillotine:
            setTool(ui::Tool::guillotine);
            return;
        case ui::ActionId::toolGrab:
            setTool(ui::Tool::grab);
            return;
        case ui::ActionId::toolPin:
            setTool(ui::Tool::pin);
            return;
        case ui::ActionId::freePins:
            freePins();
            return;
        case ui::ActionId::bringDown:
            hand.bringDown(*scene);
            return;
        case ui::ActionId::letFall:
            letFall();
            return;
        case ui::ActionId::record:
            toggleRecording();
            return;
        case ui::ActionId::saveSession:
            browse(ui::FilePurpose::saveSession);
            return;
        case ui::ActionId::sceneScreenshot:
            saveSceneScreenshot();
            return;
        case ui::ActionId::exportBody:
            browse(ui::FilePurpose::exportMesh);
            return;
        case ui::ActionId::loop:
            scene->toggleLoop();
            return;
        case ui::ActionId::slower:
            clock.setSpeed(clock.speed() / 2);
            return;
        case ui::ActionId::faster:
            clock.setSpeed(clock.speed() * 2);
            return;
        case ui::ActionId::toggleGravity:
            toggleGravity();
            return;
        default:
            performOnView(id);
    }
}

void Editor::State::cancel() {
    if (helpOpen) {
        helpOpen = false;
    } else if (isWorking() && !handIsBusy()) {
        cancelWork();
    } else if (scene != nullptr) {
        releaseHands();
        sceneChanged = true;
    }
}

void Editor::State::freePins() {
    if (scene->simulation().pinnedVertices().empty()) {
        return;
    }
    Bounds everywhere;
    everywhere.add(Vec3::Constant(-kMaxSessionCoordinate));
    everywhere.add(Vec3::Constant(kMaxSessionCoordinate));
    execute(Pin{everywhere, false});
}

void Editor::State::letFall() {
    if (scene->simulation().params().gravity.norm() == 0) {
        toggleGravity();
    }
    scene->playing = true;
}

void Editor::State::toggleGravity() {
    const bool on = scene->simulation().params().gravity.norm() > 0;
    const Vec3 before = scene->document().session.params.gravity;
    const Vec3 switchedOn = before.norm() > 0 ? before : kEarthGravity;
    execute(SetParam{"gravity", on ? Vec3(Vec3::Zero()) : switchedOn});
}

}  // namespace kerf::app
