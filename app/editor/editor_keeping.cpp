// What keeps work from being lost: the journal, what windows left behind, questions before it goes.
#include <spdlog/spdlog.h>

#include "app/editor/editor_state.h"
#include "app/scene/document/editor_document.h"

namespace kerf::app {
namespace {

using State = Editor::State;

/// The choices of askBefore().
enum UnsavedChoice { kSave, kDoNotSave, kStay };

void goOnFrom(State& s, const LeftWork& left) {
    OpeningOrder order = orderOf(left);
    order.shown = [&s, journal = left.journal] {
        s.keeping.begin(journal);
        s.sessionFile.begin({});
        s.scene->goToEnd();
        s.offers.comingBack = true;
    };
    s.offers.putOff();
    s.open(std::move(order));
}

}  // namespace

void Editor::State::keepWork(double elapsedSeconds) {
    if (scene == nullptr || scene.underWay() || closing) {
        return;
    }
    keeping.follow(*scene, view.saved(), view.display.settings.colors,
                   panels.settings.now.keepsJournal, elapsedSeconds);
    if (const std::optional<std::string> problem = keeping.takeProblem()) {
        spdlog::error("{}", *problem);
        toast.show(*problem, true);
    }
}

void Editor::State::keepPicture() {
    if (keeping.pictureDue() == 0.0 && !closing && !view.faulty) {
        keeping.keepPicture(picture.readFree(view));
    }
}

/// Before anything is done: afterwards it would have to be asked what becomes of that.
void Editor::State::offerLeftWork() {
    offers.collect();
    const bool busy = panels.asked || chooser.isOpen() || work.opening() != nullptr || closing;
    if (busy || view.holds() || hasUnsavedWork()) {
        return;
    }
    std::optional<LeftWork> left = offers.next();
    if (!left) {
        return;
    }
    panels.asked = {questionAbout(*left), [this, left = *left](int choice) {
                        if (choice == kGoOn) {
                            goOnFrom(*this, left);
                        } else if (choice == kDiscard) {
                            left.journal->remove();
                        } else {
                            offers.putOff();
                        }
                    }};
    redraw.panels();
}

/// As soon as nothing else is asked.
void Editor::State::tellOfDriver() {
    if (panels.asked || chooser.isOpen() || closing || view.holds()) {
        return;
    }
    const std::optional<DriverProblem> problem = driverCheck.takeProblem();
    if (!problem) {
        return;
    }
    spdlog::error("{}", problem->sentence);
    panels.asked = {questionAbout(*problem), [this](int choice) {
                        if (choice == kUseSoftware) {
                            panels.settings.now.softwareRenderer = true;
                            toast.show("Restart Kerf to use the software renderer.", false);
                        }
                    }};
    redraw.panels();
}

void Editor::State::leaveScene() {
    panels.asked.reset();
    hideFaulty();
    sceneHistory.clear();
    work.onceSaved = nullptr;
    offers.comingBack = false;
    work.stopPlacing();
    link.stop();
    scene.set(nullptr);
    clock.stop();
    toast.withdrawOffer();
}

void Editor::State::giveUpScene(const std::string& sentence) {
    const bool unsaved = hasUnsavedWork();
    leaveScene();
    const bool kept = keeping.leave() && unsaved;
    if (kept) {
        offers.lookAgain();
    }
    describeScene();
    redraw.scene();
    complain(kept ? sentence + " Your work was saved for recovery." : sentence);
}

bool Editor::State::comesBack() {
    offers.comingBack = offers.comingBack && scene != nullptr && scene.meanwhile().seekSteps() > 0;
    return offers.comingBack;
}

bool Editor::State::hasUnsavedWork() const {
    const BusyScene now = scene.meanwhile();
    return now && keeping.isUnsaved(now.deeds());
}

void Editor::State::askBefore(const std::string& what, const std::function<void()>& next) {
    if (!hasUnsavedWork()) {
        next();
        return;
    }
    const auto askAgain = [this, what, next] { askBefore(what, next); };
    if (work.onceSaved && work.saving() != nullptr) {
        work.afterSaving = askAgain;
        return;
    }
    askToSave({what + " without saving?",
               "Your changes to " + scene.meanwhile().document().name +
                   " have not been saved. You can continue later from a saved session.",
               {"", "Don't save", "Cancel"}},
              askAgain, next);
}

void Editor::State::askToSave(ui::Question question, std::function<void()> saved,
                              std::function<void()> next) {
    question.choices[kSave] = sessionFile.path().empty() ? "Save..." : "Save";
    panels.asked = {std::move(question),
                    [this, saved = std::move(saved), next = std::move(next)](int choice) {
                        if (choice == kSave) {
                            saveSession();
                            work.afterSaving = saved;
                        } else if (choice == kDoNotSave) {
                            next();
                        }
                    }};
    redraw.panels();
}

void Editor::State::leave() {
    chooser.take(ui::CloseFileDialog{});
    askBefore("Quit", [this] {
        closing = true;
        keeping.discard();
        redraw.panels();
    });
}

}  // namespace kerf::app
