#include <spdlog/spdlog.h>

#include <memory>
#include <new>
#include <utility>

#include "app/editor/editor_state.h"
#include "app/files/io/file_io.h"
#include "app/scene/timeline/scene_recorder.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

/// The choices of askAboutTest().
enum PictureChoice { kAddPicture, kNoPicture, kCancel };

}  // namespace

// --- Opening -----------------------------------------------------------------------------------

void Editor::State::open(OpeningOrder order, const Mending& mending) {
    asked.reset();
    beingMended.reset();
    hideFaulty();
    work.open(std::move(order), mending);
}

void Editor::State::addModel(const std::filesystem::path& file) {
    if (scene == nullptr) {
        open(file);
        return;
    }
    openScene(
        {"Adding " + file.filename().string(), file,
         [name = scene->document().name, start = scene->body().start(),
          file](const ReadOptions& options) { return openWithModel(name, start, file, options); }});
}

void Editor::State::removeModel(int model) {
    Session start = scene->body().start();
    takeModelOut(start, model);
    const std::filesystem::path file = start.model.file();
    openScene({"Taking model " + std::to_string(model) + " out", file,
               [name = scene->document().name, start](const ReadOptions& options) {
                   return kerf::app::openScene(name, start, options);
               }});
}

/// The scene begins anew: who has cut is asked.
void Editor::State::openScene(OpeningOrder order) {
    if (!scene->timeline().hasChanged()) {
        open(std::move(order));
        return;
    }
    asked = {{order.title + " starts the scene anew",
              "The cuts and other changes of the models so far go, and undo does not bring them "
              "back. Save the session first if you want them again.",
              {"Start anew", "Cancel"}},
             [this, order](int choice) {
                 if (choice == 0) {
                     open(order);
                 }
             }};
}

void Editor::State::show(UploadedDocument uploaded) {
    const std::string note = uploaded.document.note;
    // Either may fail for want of memory; what is open stays then.
    auto next =
        std::make_unique<EditorScene>(std::move(uploaded.document), std::move(uploaded.body));
    picture.setRestDepth(uploaded.depth);
    scene.set(std::move(next));
    depths.note(scene->simulation().uncut(), std::move(uploaded.depth));
    sceneSteps.clear();
    mended = std::exchange(beingMended, std::nullopt);
    waiting.clear();
    keeping.begin();
    view.begin(*scene);
    beginScene();
    if (scene->document().guess && !scene->document().guess->certain) {
        panels.unfold("model");  // The guess is a question, too.
    }
    tellOfModel(note);
}

void Editor::State::beginScene() {
    work.stopPlacing();
    exchangeWanted = Exchange::none;
    comingBack = false;
    onceSaved = nullptr;
    guide.begin(*scene);
    kernels.begin();
    chooser.setModel(scene->document().session.model.path);
    panels.plotView = {};
    clock.stop();
    toast.withdrawOffer();
    describeScene();  // It may begin to work at once, and what was told is of the one before.
    redraw.scene();
}

void Editor::State::place(const Place& command) {
    work.stopPlacing();
    const Simulation& simulation = scene->simulation();
    const bool known = command.model < simulation.modelCount();
    if (known && !told.model.live) {
        work.place(std::make_unique<BodyPlacing>(simulation, command));
    } else {
        say(scene->execute(command));
    }
    redraw.panels();
}

/// The scene goes on as it is until the hand is free and it rests.
void Editor::State::followPlacing() {
    if (work.placing() == nullptr) {
        return;
    }
    redraw.panels();
    if (view.holds() || scene.underWay() || !waiting.empty()) {
        return;
    }
    const std::unique_ptr<BodyPlacing> placing = work.takePlacing();
    if (placing == nullptr) {
        return;
    }
    try {
        PlacedBody placed = placing->take();
        depths.note(placed.body, std::move(placed.depth));
        scene->simulation().expectPlacement(std::move(placed.body));
    } catch (const std::bad_alloc&) {
        complain(outOfMemory("Placing the model"));
        return;
    } catch (const std::exception& error) {
        complain(error.what());
        return;
    }
    scene.begin(SceneWork::change, [this, command = placing->command()](EditorScene& now) {
        view.cancelTools({&now, false});
        say(now.execute(command));
    });
    goOn();
}

// --- Choosing and saving -----------------------------------------------------------------------

void Editor::State::browse(ui::FilePurpose purpose, BrowseFor what) {
    chooser.browse(purpose, scene == nullptr ? "" : scene.meanwhile().document().name, what);
}

/// A test without a picture is one too, but it can't show what has changed.
void Editor::State::askAboutTest() {
    if (scene.meanwhile().takesPictures()) {
        browse(ui::FilePurpose::saveTest);
        return;
    }
    asked = {{"The session takes no picture yet",
              "A test compares the states, counts and volumes of its session, and its pictures.",
              {"Add a picture of the end", "Go without", "Cancel"}},
             [this](int choice) {
                 if (choice != kCancel) {
                     browse(ui::FilePurpose::saveTest,
                            choice == kAddPicture ? BrowseFor::testWithPicture : BrowseFor::itself);
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
    save(chosen);
    if (chosen.purpose == ui::FilePurpose::saveSession ||
        chosen.purpose == ui::FilePurpose::saveTest) {
        chooser.addRecent(chosen.file);
    }
}

void Editor::State::openAsked(const std::filesystem::path& file) {
    if (!isMaterialFile(file)) {
        askBefore("Open " + file.filename().string(), [this, file] { open(file); });
        return;
    }
    try {
        const int number = materials.add(file);
        if (scene == nullptr) {
            toast.show("Open a model first; " + file.filename().string() + " is a material.", true);
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

/// One file after the other.
void Editor::State::save(const ChosenFile& chosen) {
    if (const FileSaving* const before = work.saving()) {
        toast.show(before->title + " is not done yet; save again after it.", true);
        return;
    }
    if (scene == nullptr) {
        return;
    }
    if (chosen.purpose == ui::FilePurpose::exportMesh) {
        onceSaved = nullptr;
        const auto coordinates = chosen.inScene ? Coordinates::scene : Coordinates::model;
        work.save(startExport({chosen.file, chosen.filePerPiece, coordinates}, scene->document(),
                              scene->simulation(), view.display.look(scene->document())));
        return;
    }
    if (chosen.purpose == ui::FilePurpose::saveMaterial) {
        onceSaved = [this] { lookForMaterials(); };
        work.save(startSavingMaterial(
            chosen.file, materialFrom(scene->simulation().params(), view.display.settings.colors)));
        return;
    }
    if (chosen.purpose == ui::FilePurpose::makeFilm) {
        onceSaved = nullptr;
        SavedSession filmed =
            scene->recorder().savedSession(view.camera.destination(), view.display.settings.colors);
        filmed.session.view = view.camera.destination();  // also where the file has another
        work.save(startFilm(chosen.file, chosen.film, std::move(filmed)));
        return;
    }
    if (chosen.what == BrowseFor::testWithPicture) {
        scene->recorder().addPicture(scene->recorder().end());
    }
    onceSaved = [this, deeds = scene->recorder().deeds()] { keeping.noteSaved(deeds); };
    const bool isTest = chosen.purpose == ui::FilePurpose::saveTest;
    SavedSession saved =
        scene->recorder().savedSession(view.camera.destination(), view.display.settings.colors,
                                       isTest ? SavedAs::test : SavedAs::session);
    work.save(isTest ? startSavingTest(chosen.file, std::move(saved))
                     : startSaving(chosen.file, std::move(saved)));
}

int Editor::State::savePicture(render::Image image, const std::string& name) {
    return work.saveBehind(name, ".png",
                           [image = std::move(image)](const std::filesystem::path& file) {
                               writePicture(image, file);
                           });
}

// --- Once a picture ----------------------------------------------------------------------------

void Editor::State::followFiles() {
    followOpening();
    followPlacing();
    while (const auto outcome = work.takeOutcome()) {
        spdlog::log(outcome->failed ? spdlog::level::err : spdlog::level::info, "{}",
                    outcome->sentence);
        toast.show(*outcome);
        redraw.panels();
        onSaved(*outcome);
        materials.look();  // It may have been one.
    }
    if (!chooser.isOpen() && work.saving() == nullptr) {
        afterSaving = nullptr;  // The dialog was left without a name, or the file not written.
    }
    if (chooser.followPreview()) {
        redraw.panels();
    }
}

void Editor::State::onSaved(const SavingQueue::Outcome& outcome) {
    constexpr int kNoNumber = 0;  // not of FileWork::saveBehind()
    if (outcome.number != kNoNumber || !onceSaved) {
        return;
    }
    const auto then = std::exchange(onceSaved, nullptr);
    if (outcome.failed) {
        return;
    }
    then();
    if (!chooser.isOpen() && afterSaving) {
        std::exchange(afterSaving, nullptr)();
    }
}

/// The scene stays as it is until the new one stands and the hand is free.
void Editor::State::followOpening() {
    if (work.opening() == nullptr) {
        return;
    }
    const OpeningOrder order = work.opening()->order();
    redraw.panels();
    try {
        const bool rests = order.change.empty() || (!scene.underWay() && waiting.empty());
        if (auto uploaded = work.advanceOpening(rests && !view.holds())) {
            if (order.change.empty()) {
                show(std::move(*uploaded));
            } else {
                exchange(std::move(*uploaded), order.change);
            }
            if (!order.file.empty() && order.change.empty()) {
                chooser.addRecent(order.file);
            }
            if (order.shown) {
                order.shown();
            }
        }
    } catch (const ModelFault& fault) {
        spdlog::error("{}", fault.what());
        askAboutMending(fault, order);
    } catch (const std::bad_alloc&) {
        complain(outOfMemory(order.title));
    } catch (const std::exception& error) {
        complain(error.what());
    }
}

}  // namespace kerf::app
