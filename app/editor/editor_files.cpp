#include <spdlog/spdlog.h>

#include <new>

#include "app/editor/editor_state.h"
#include "app/editor/editor_task.h"
#include "app/editor/view/editor_panels.h"
#include "app/files/io/file_io.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/timeline/scene_recorder.h"

namespace kerf::app {
namespace {

using State = Editor::State;

/// The choices of askAboutTest().
enum PictureChoice { kAddPicture, kNoPicture, kCancel };

/// Why a model can't be cut.
void showFaults(State& s, const ModelFault& fault, const OpeningOrder& order) {
    spdlog::error("{}", fault.what());
    s.view.showFaulty(fault, order);
    s.toast.show(fault.what(), true);
    s.redraw.scene();
}

/// The scene stays as it is until the new one stands and the hand is free.
void followOpening(State& s) {
    if (s.work.opening() == nullptr) {
        return;
    }
    const OpeningOrder order = s.work.opening()->order();
    const Mending& mending = s.work.opening()->mending();
    const bool asksAgain =
        mending == Mending{} || mending.thicken;  // perhaps for another thickness
    s.redraw.panels();
    try {
        const bool rests = order.change.empty() || (!s.scene.underWay() && s.scene.waiting.empty());
        if (auto uploaded = s.work.advanceOpening(rests && !s.view.holds())) {
            std::string& note = uploaded->document.note;
            note = order.remark + (order.remark.empty() || note.empty() ? "" : " ") + note;
            if (order.complete) {
                order.complete(uploaded->document);
            }
            if (order.change.empty()) {
                s.show(std::move(*uploaded));
            } else {
                s.exchange(std::move(*uploaded), order.change);
            }
            if (!order.file.empty() && order.change.empty()) {
                s.chooser.addRecent(order.file);
            }
            if (order.atEnd) {
                s.scene->goToEnd();
                s.offers.comingBack = s.scene->timeline().seekSteps() > 0;
            }
            if (order.shown) {
                order.shown();
            }
        }
    } catch (const ModelFault& fault) {
        showFaults(s, fault, order);
        if (asksAgain) {
            s.work.lookForRepair(order);
        }
    } catch (const std::bad_alloc&) {
        s.complain(outOfMemory(order.title));
    } catch (const std::exception& error) {
        s.complain(error.what());
    }
}

/// The faults are shown meanwhile.
void followSearch(State& s) {
    if (s.work.search() == nullptr) {
        return;
    }
    s.redraw.panels();
    const std::unique_ptr<RepairSearch> search = s.work.takeSearch();
    if (search == nullptr) {
        return;
    }
    try {
        s.askAboutMending(search->take(), search->order());
    } catch (const std::bad_alloc&) {
        s.complain(outOfMemory("Looking for a repair"));
    } catch (const std::exception& error) {
        s.complain(error.what());
    }
}

/// The scene goes on as it is until the hand is free and it rests.
void followPlacing(State& s) {
    if (s.work.placing() == nullptr) {
        return;
    }
    s.redraw.panels();
    if (s.view.holds() || s.scene.underWay() || !s.scene.waiting.empty()) {
        return;
    }
    const std::unique_ptr<BodyPlacing> placing = s.work.takePlacing();
    if (placing == nullptr) {
        return;
    }
    try {
        PlacedBody placed = placing->take();
        s.picture.depths.note(placed.body, std::move(placed.depth));
        s.scene->simulation().expectPlacement(std::move(placed.body));
    } catch (const std::bad_alloc&) {
        s.complain(outOfMemory("Placing model"));
        return;
    } catch (const std::exception& error) {
        s.complain(error.what());
        return;
    }
    s.scene.begin(SceneWork::change, [&s, command = placing->command()](EditorScene& now) {
        s.view.cancelTools({&now, false});
        s.say(now.execute(command));
    });
    s.goOn();
}

/// Handles the end of a save.
void onSaved(State& s, const SavingQueue::Outcome& outcome) {
    constexpr int kNoNumber = 0;  // not of FileWork::saveBehind()
    if (outcome.number != kNoNumber) {
        return;
    }
    const auto saved = std::exchange(s.work.onceSaved, nullptr);
    const auto notSaved = std::exchange(s.work.ifNotSaved, nullptr);
    if (const auto& next = outcome.failed ? notSaved : saved) {
        next();
    }
    if (outcome.failed || !saved) {
        return;
    }
    if (!s.chooser.isOpen() && s.work.afterSaving) {
        std::exchange(s.work.afterSaving, nullptr)();
    }
}

}  // namespace

// --- Opening -----------------------------------------------------------------------------------

void Editor::State::open(OpeningOrder order, const Mending& mending) {
    panels.asked.reset();
    sceneHistory.beingMended.reset();
    hideFaulty();
    work.open(std::move(order), mending);
}

void Editor::State::openStartScene(std::size_t card) {
    const ui::StartCard& wanted = startCards()->at(card);
    OpeningOrder order = orderOf(startSession(wanted.name), sessionFile.ends);
    order.title = "Opening " + wanted.title;
    order.file.clear();  // none of the recent files
    order.shown = [this, tip = wanted.tip, tool = wanted.tool] {
        guide.suggest(tip);
        view.tools.settings().tool = tool;
    };
    askBefore("Open " + wanted.title, [this, order] { open(order); });
}

void Editor::State::show(UploadedDocument uploaded) {
    const std::string note = uploaded.document.note;
    if (uploaded.document.inFile) {
        sessionFile.begin(uploaded.document.file);
    }
    // Either may fail for want of memory; what is open stays then.
    auto next =
        std::make_unique<EditorScene>(std::move(uploaded.document), std::move(uploaded.body));
    picture.depths.note(next->simulation().uncut(), std::move(uploaded.depth));
    picture.setBody(next->simulation().uncut());
    scene.set(std::move(next));
    sceneHistory.clear();
    sceneHistory.mended = std::exchange(sceneHistory.beingMended, std::nullopt);
    keeping.begin();
    view.begin(*scene);
    if (scene->document().session.task) {
        view.takeToolsOf(*scene->document().session.task);
    }
    if (scene->document().session.editor) {
        view.show(*scene->document().session.editor);
    }
    beginScene();
    panels.startOpen = false;
    if (scene->document().guess && !scene->document().guess->certain) {
        panels.unfold("model");  // The guess is a question, too.
    }
    tellOfModel(note);
}

void Editor::State::beginScene() {
    work.stopPlacing();
    sceneHistory.wanted = SceneHistory::Exchange::none;
    offers.comingBack = false;
    scene.onceSought = nullptr;
    work.onceSaved = nullptr;
    scene->readout().plot(std::nullopt);  // The list of measurements begins anew.
    work.models.begin(app::modelFiles(scene->document().session));
    guide.begin(*scene);
    link.begin(*scene);
    const std::filesystem::path& session = sessionFile.path();
    chooser.setSource(session.empty() ? scene->document().session.model.path : session);
    panels.plotView = {};
    clock.begin();
    toast.withdrawOffer();
    describeScene();  // It may begin to work at once, and what was told is of the one before.
    redraw.scene();
}

void Editor::State::place(const Place& command) {
    work.stopPlacing();
    const Simulation& simulation = scene->simulation();
    const bool known = command.model < simulation.modelCount();
    if (known && !panels.told.model.live) {
        work.place(std::make_unique<BodyPlacing>(simulation, command));
    } else {
        say(scene->execute(command));
    }
    redraw.panels();
}

// --- Choosing and saving -----------------------------------------------------------------------

void Editor::State::browse(ui::FilePurpose purpose, BrowseFor what) {
    chooser.browse(purpose, scene == nullptr ? "" : scene.meanwhile().document().name, what);
}

void Editor::State::saveSession() {
    const std::string doubt = sessionFile.doubt();
    if (sessionFile.path().empty()) {
        browse(ui::FilePurpose::saveSession);
    } else if (doubt.empty()) {
        save({ui::FilePurpose::saveSession, sessionFile.path()});
    } else {
        panels.asked = {{"Replace " + sessionFile.path().filename().string() + "?",
                         doubt,
                         {"Replace", "Save as...", "Cancel"}},
                        [this](int choice) {
                            if (choice == 0) {
                                save({ui::FilePurpose::saveSession, sessionFile.path()});
                            } else if (choice == 1) {
                                browse(ui::FilePurpose::saveSession);
                            }
                        }};
    }
}

/// A test without a picture is one too, but it can't show what has changed.
void Editor::State::askAboutTest() {
    if (scene.meanwhile().takesPictures()) {
        browse(ui::FilePurpose::saveTest);
        return;
    }
    panels.asked = {{"This session has no pictures",
                     "A test compares states, counts, volumes and pictures. Without a picture it "
                     "can't notice visible changes.",
                     {"Add picture of last step", "Continue without", "Cancel"}},
                    [this](int choice) {
                        if (choice != kCancel) {
                            browse(ui::FilePurpose::saveTest, choice == kAddPicture
                                                                  ? BrowseFor::testWithPicture
                                                                  : BrowseFor::itself);
                        }
                    }};
}

void Editor::State::take(const ChosenFile& chosen) {
    if (chosen.purpose == ui::FilePurpose::open) {
        if (chosen.what == BrowseFor::addition) {
            addModel(chosen.file);
        } else {
            openAsked(chosen.file);
        }
        return;
    }
    // Tests and films fail by what they replay, too.
    const bool byItsNameAlone =
        chosen.purpose != ui::FilePurpose::saveTest && chosen.purpose != ui::FilePurpose::makeFilm;
    const bool begins = work.saving() == nullptr;
    save(chosen);
    if (begins && byItsNameAlone) {
        work.ifNotSaved = [this, chosen] { chooser.browseAgain(chosen); };
    }
    if (chosen.purpose == ui::FilePurpose::saveSession ||
        chosen.purpose == ui::FilePurpose::saveTest) {
        chooser.addRecent(chosen.file);
    }
}

void Editor::State::openAsked(const std::filesystem::path& file, const std::string& remark) {
    if (!isMaterialFile(file)) {
        askBefore("Open " + file.filename().string(), [this, file, remark] {
            OpeningOrder order = orderOf(file, sessionFile.ends);
            order.remark = remark;
            open(std::move(order));
        });
        return;
    }
    try {
        const int number = materials.add(file);
        if (scene == nullptr) {
            toast.show("Open a model first: " + file.filename().string() + " is a material.", true);
        } else {
            apply(ui::TakeMaterial{number, 0});
        }
    } catch (const InputError& error) {
        toast.show(error.what(), true);
    }
}

void Editor::State::lookForMaterials() {
    for (const std::string& problem : materials.look()) {
        spdlog::warn("{}", problem);
        toast.show(problem, true);
    }
}

void Editor::State::takeMaterial(const ui::TakeMaterial& wanted) {
    const Material* const material = materials.find(wanted.material);
    if (material == nullptr) {
        return;
    }
    const Material taken = *material;
    for (const SetParam& set : settingsOf(taken, wanted.model)) {
        if (!execute(set)) {
            return;
        }
    }
    if (wanted.model == 0 && taken.colors.any()) {
        view.display.settings.colors = taken.colors;
        redraw.scene();
    }
}

void Editor::State::browseToSaveMaterial() {
    std::error_code ignored;  // The dialog then looks into the next folder that is there.
    std::filesystem::create_directories(materials.folder(), ignored);
    browse(ui::FilePurpose::saveMaterial);
}

namespace {

void exportTo(Editor::State& s, const ChosenFile& chosen) {
    EditorScene& scene = *s.scene;
    ExportTarget target{chosen.file, chosen.filePerPiece,
                        chosen.inScene ? Coordinates::scene : Coordinates::model};
    if (chosen.what == BrowseFor::selectedPiece) {
        const std::vector<int> places = scene.simulation().trianglesOfPieces();
        const auto piece = static_cast<std::size_t>(s.view.display.pieces.selected);
        if (piece >= places.size()) {
            s.toast.show("The piece to be exported is gone.", true);
            return;
        }
        target.pieceAt = places[piece];
    }
    s.work.onceSaved = nullptr;
    s.work.save(startExport(std::move(target), scene.document(), scene.simulation(),
                            s.view.display.look(scene.document())));
}

}  // namespace

/// One file after the other.
void Editor::State::save(const ChosenFile& chosen) {
    if (const FileSaving* const before = work.saving()) {
        toast.show("Still busy: " + before->title + ". Save again when it is done.", true);
        return;
    }
    work.ifNotSaved = nullptr;
    if (scene == nullptr) {
        return;
    }
    if (chosen.purpose == ui::FilePurpose::exportMesh) {
        exportTo(*this, chosen);
        return;
    }
    if (chosen.purpose == ui::FilePurpose::saveMaterial) {
        work.onceSaved = [this] { lookForMaterials(); };
        work.save(startSavingMaterial(
            chosen.file, materialFrom(scene->simulation().params(), view.display.settings.colors)));
        return;
    }
    if (chosen.purpose == ui::FilePurpose::makeFilm) {
        work.onceSaved = nullptr;
        SavedSession filmed =
            scene->recorder().savedSession(view.camera.destination(), view.display.settings.colors);
        filmed.session.view = view.camera.destination();  // also where the file has another
        work.save(startFilm(chosen.file, chosen.film, std::move(filmed)));
        return;
    }
    if (chosen.what == BrowseFor::testWithPicture) {
        scene->recorder().addPicture(scene->recorder().end());
    }
    const bool isTest = chosen.purpose == ui::FilePurpose::saveTest;
    work.onceSaved = [this, isTest, deeds = scene->recorder().deeds(), file = chosen.file] {
        keeping.noteSaved(deeds);
        if (!isTest) {
            sessionFile.noteWritten(file);
            scene->body().document.name = shortName(file);
        }
    };
    SavedSession saved =
        scene->recorder().savedSession(view.camera.destination(), view.display.settings.colors,
                                       isTest ? SavedAs::test : SavedAs::session);
    if (!isTest) {
        saved.session.editor = view.saved();
    }
    const bool isTask = !isTest && scene->document().makesTask;
    if (isTask) {
        leaveTask(*this, chosen.file, saved);
    }
    for (const std::filesystem::path& model : changedModels(scene->document())) {
        saved.remark +=
            (saved.remark.empty() ? "" : " ") + model.filename().string() +
            (std::filesystem::exists(model)
                 ? " has changed since it was read; the saved session will use the new version."
                 : " is gone; the saved session needs it.");
    }
    work.save(isTest ? startSavingTest(chosen.file, std::move(saved))
                     : startSaving(chosen.file, std::move(saved),
                                   isTask ? std::nullopt : scene->recorder().savedEnd(),
                                   sessionFile.ends));
}

int Editor::State::savePicture(render::Image image, const std::string& name) {
    return work.saveBehind(name, ".png",
                           [image = std::move(image)](const std::filesystem::path& file) {
                               writePicture(image, file);
                           });
}

// --- Once a picture ----------------------------------------------------------------------------

void Editor::State::followFiles() {
    followOpening(*this);
    followSearch(*this);
    followPlacing(*this);
    while (const auto outcome = work.takeOutcome()) {
        spdlog::log(outcome->failed ? spdlog::level::err : spdlog::level::info, "{}",
                    outcome->sentence);
        toast.show(*outcome);
        redraw.panels();
        onSaved(*this, *outcome);
        materials.look();  // It may have been one.
    }
    if (!chooser.isOpen() && !panels.asked && work.saving() == nullptr) {
        work.afterSaving = nullptr;  // The dialog was left without a name, or the file not written.
    }
    if (chooser.followPreview()) {
        redraw.panels();
    }
}

}  // namespace kerf::app
