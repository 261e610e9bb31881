#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/editor/editor.h"
#include "app/editor/steps/kernel_preparation.h"
#include "app/editor/steps/scene_at_work.h"
#include "app/editor/steps/scene_steps.h"
#include "app/editor/steps/step_clock.h"
#include "app/editor/storage/driver_check.h"
#include "app/editor/storage/file_chooser.h"
#include "app/editor/storage/file_work.h"
#include "app/editor/storage/left_work.h"
#include "app/editor/storage/material_shelf.h"
#include "app/editor/storage/work_keeping.h"
#include "app/editor/view/editor_panels.h"
#include "app/editor/view/editor_picture.h"
#include "app/editor/view/editor_toast.h"
#include "app/editor/view/editor_view.h"
#include "app/editor/view/first_steps.h"
#include "app/editor/view/input_queue.h"
#include "app/editor/view/redraw.h"

namespace kerf::app {

/// The parts of an editor, and what joins several of them. The functions stand in a file per
/// concern, as the headings say.
struct Editor::State {
    explicit State(const EditorOptions& options)
        : kernels(options.warmsUp),
          redraw(options.drawsAll),
          clock(options.byTheClock, options.portion),
          panels(options),
          picture(options.quality),
          chooser(options.screenshotFolder, options.recentFiles),
          materials(options.materials),
          work(options.screenshotFolder),
          keeping(options.journals),
          offers(options.journals),
          driverCheck(options.driverReports, options.driver) {
        view.resize(options.width, options.height);
        view.display.settings.quality = options.quality;
        chooser.setMaterialFolder(materials.folder());
        lookForMaterials();
    }

    KernelPreparation kernels;  ///< first: its programs outlive what is made of them
    InputQueue queue;
    Redraw redraw;
    StepClock clock;
    EditorPanels panels;
    EditorPicture picture;
    SceneAtWork scene;      ///< null while nothing is open
    SceneSteps sceneSteps;  ///< the scenes before and after it
    EditorView view;
    EditorToast toast;
    NewcomerGuide guide;
    FileChooser chooser;
    MaterialShelf materials;
    FileWork work;
    WorkKeeping keeping;
    LeftWorkOffers offers;
    DriverCheck driverCheck;
    bool closing = false;

    // A picture: editor.cpp.
    /// One picture, as Editor::frame() makes it.
    void makePicture(double elapsedSeconds);
    /// Works, and gives the scene up where memory runs out.
    void sparingly(const std::function<void()>& doWork);
    /// Does what waits for the scene, as far as that takes no longer than a portion.
    void workOff();
    /// Goes on with what the scene is doing.
    void goOn();
    /// Says what went wrong, in the log too.
    void complain(const std::string& sentence);
    /// Scene and panels.
    void draw();

    // Input: editor_input.cpp.
    void takeInput(double elapsedSeconds);
    /// The scene once what it does is done.
    BusyScene restingScene() { return {scene.get(), false}; }
    /// That for a tool that is to let go: it waits where it holds the body.
    BusyScene sceneOfTool() { return view.tools.holdsBody() ? restingScene() : scene.meanwhile(); }

    // Answers to keys and panels: editor_actions.cpp.
    /// Does what was asked for, at once or once the scene is done with what it does.
    void apply(const ui::Action& action);
    void answer(const ui::Action& action);
    /// Does a command to the open body. False where that failed, which is said in the view.
    bool execute(const Command& command);
    /// Shows what came of something that was done to the body: "" or one sentence.
    void say(const std::string& problem);

    // Files: editor_files.cpp.
    void open(const std::filesystem::path& file) { open(orderOf(file)); }
    /// The same, after a question about work that is not saved. A material is taken at once.
    void openAsked(const std::filesystem::path& file);
    void open(OpeningOrder order, const Mending& mending = {});
    void removeModel(int model);
    void show(UploadedDocument uploaded);
    /// What follows where another scene is open than before.
    void beginScene();
    void followFiles();
    /// Places a model: a large one is prepared behind the scene first.
    void place(const Place& command);
    void askAboutMending(const ModelFault& fault, const OpeningOrder& order);

    // Faults, and what is done about them: editor_faults.cpp.
    /// Shows the scene again.
    void hideFaulty();
    /// Begins to exchange a model for one with even triangles, after a question where it was cut.
    void remesh(const ui::Remesh& wanted);
    /// Shows what is told of what was opened, and offers to remesh a model whose skin is coarse.
    void tellOfModel(std::string note);
    void unitePieces(int model);
    /// Exchanges the only model for one for each object of its file.
    void partModel();
    /// The scene with even triangles is there: it takes the place of the one before, which is kept.
    void exchange(UploadedDocument uploaded, const std::string& change);
    /// Does an exchange that undo or redo asked for.
    void followExchange();
    /// Whether an undo takes the whole scene back, which it asks for then.
    bool undoesScene();
    bool redoesScene();
    /// Goes to a row of the history, which may be of another scene.
    void goToChange(std::size_t done);
    /// Adds what the panels show of faults and of other scenes.
    void describeFaults();
    void browse(ui::FilePurpose purpose, BrowseFor what = BrowseFor::itself);
    void askAboutTest();
    void take(const ChosenFile& chosen);
    void save(const ChosenFile& chosen);
    int savePicture(render::Image image, const std::string& name);

    /// Lists the materials anew, and tells of those that can't be read.
    void lookForMaterials();
    /// Gives a model a material: one change, and the look with it.
    void takeMaterial(const ui::TakeMaterial& wanted);
    void browseToSaveMaterial();

    // Work that must not be lost: editor_keeping.cpp.
    void keepWork(double elapsedSeconds);
    /// Keeps a small picture of the scene, where one is due.
    void keepPicture();
    /// Asks what becomes of what a window left behind, if there is any.
    void offerLeftWork();
    void tellOfDriver();
    /// Lets go of the scene and of all that concerns it: nothing is open then.
    void leaveScene();
    /// The scene could not go on, for the reason that `sentence` gives: nothing is open then, and
    /// what was done is offered as work that was left behind.
    void giveUpScene(const std::string& sentence);
    /// Whether it is still being played: what is done now would leave the rest of it out.
    bool comesBack();
    bool hasUnsavedWork() const;
    /// Does `next`, before which a person is asked about work that is not saved: "WHAT and lose
    /// what was done?"
    void askBefore(const std::string& what, const std::function<void()>& next);
    void leave();

    // What the panels show: editor_description.cpp.
    /// Fills it in. Without `withOverlay` the lines of the coming cut stay as they were.
    void describe(bool withOverlay);
    void describeScene();
    /// The title of the window.
    std::string title() const;
};

}  // namespace kerf::app
