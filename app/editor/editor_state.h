#pragma once

#include "app/editor/editor.h"
#include "app/editor/steps/scene_at_work.h"
#include "app/editor/steps/scene_history.h"
#include "app/editor/steps/scene_link.h"
#include "app/editor/steps/step_clock.h"
#include "app/editor/storage/driver_check.h"
#include "app/editor/storage/file_chooser.h"
#include "app/editor/storage/file_work.h"
#include "app/editor/storage/material_shelf.h"
#include "app/editor/storage/work_keeping.h"
#include "app/editor/view/editor_panels.h"
#include "app/editor/view/editor_picture.h"
#include "app/editor/view/editor_toast.h"
#include "app/editor/view/editor_view.h"
#include "app/editor/view/first_steps.h"
#include "app/editor/view/input_queue.h"
#include "app/editor/view/redraw.h"
#include "gpu/program.h"

namespace kerf::app {

/// The parts of an editor, and the functions that connect several of them, in a file per concern,
/// as the headings say.
struct Editor::State {
    explicit State(const EditorOptions& options)
        : redraw(options.drawsAll),
          clock(options.byTheClock, options.portion, options.slowStep),
          panels(options),
          picture(options.quality),
          chooser(options.screenshotFolder, options.recentFiles, panels.settings.now.folders),
          sessionFile({options.storedEnds, options.driver}),
          materials(options.materials),
          work(options.screenshotFolder),
          keeping(options.journals),
          link(options.link),
          offers(options.journals),
          driverCheck(options.driverReports, options.driver) {
        view.resize(options.width, options.height);
        view.display.settings.quality = options.quality;
        chooser.setMaterialFolder(materials.folder());
        lookForMaterials();
    }

    gpu::ProgramShelf programs;  ///< first: of all documents
    InputQueue queue;
    Redraw redraw;
    StepClock clock;
    EditorPanels panels;
    EditorPicture picture;
    SceneAtWork scene;          ///< null while nothing is open
    SceneHistory sceneHistory;  ///< the previous and the redoable scenes
    EditorView view;
    EditorToast toast;
    NewcomerGuide guide;
    FileChooser chooser;
    SessionFile sessionFile;
    MaterialShelf materials;
    FileWork work;
    WorkKeeping keeping;
    SceneLink link;
    LeftWorkOffers offers;
    DriverCheck driverCheck;
    bool closing = false;

    // A picture: editor.cpp.
    /// One frame of Editor::frame().
    void makePicture(double elapsedSeconds);
    /// Works, and closes the scene if memory runs out.
    void sparingly(const std::function<void()>& doWork);
    /// Does waiting actions, for at most a portion of time.
    void workOff();
    /// Continues the scene's work.
    void goOn();
    /// Shows and logs a problem.
    void complain(const std::string& sentence);
    /// Scene and panels.
    void draw();

    // Input: editor_input.cpp.
    void takeInput(double elapsedSeconds);
    /// The scene after its work is done.
    BusyScene restingScene() { return {scene.get(), false}; }
    /// The scene for a tool that must release: waits if it holds the body.
    BusyScene sceneOfTool() { return view.tools.holdsBody() ? restingScene() : scene.meanwhile(); }

    // Answers to keys and panels: editor_actions.cpp.
    /// Carries an action out, at once or after the scene's work.
    void apply(const ui::Action& action);
    void answer(const ui::Action& action);
    /// Executes a command on the open body. False if it failed, which is shown in the view.
    bool execute(const Command& command);
    /// Shows the result of an action on the body: "" or one sentence.
    void say(const std::string& problem);

    // Files: editor_files.cpp.
    void open(const std::filesystem::path& file) { open(orderOf(file, sessionFile.ends)); }
    /// Opens a file after a question about unsaved work, and shows the remark then. A material is
    /// applied at once.
    void openAsked(const std::filesystem::path& file, const std::string& remark = "");
    void open(OpeningOrder order, const Mending& mending = {});
    /// Opens a scene of the start page, after a question about unsaved work.
    void openStartScene(std::size_t card);
    void show(UploadedDocument uploaded);
    /// Called after another scene was opened.
    void beginScene();
    void followFiles();
    /// Places a model: a large one is prepared in the background first.
    void place(const Place& command);
    /// Offers the repairs that help.
    void askAboutMending(const ModelFault& fault, const OpeningOrder& order);

    // Other models below what was done so far: editor_models.cpp.
    /// Reopens the scene with the model of a file added, or with a model removed.
    void addModel(const std::filesystem::path& file);
    void removeModel(int model);
    /// Reads the models of the scene again.
    void reloadModels();

    // Faults, and what is done about them: editor_faults.cpp.
    /// Shows the scene again.
    void hideFaulty();
    /// Begins to remesh a model, after a question if it was cut.
    void remesh(const ui::Remesh& wanted);
    /// Shows the notes on the opened file, and offers to remesh a coarse or a slow model.
    void tellOfModel(std::string note);
    void unitePieces(int model);
    /// Replaces the only model by one for each object of its file.
    void partModel();
    /// Replaces the scene by the remeshed one, and keeps the old one.
    void exchange(UploadedDocument uploaded, const std::string& change);
    /// Does an exchange requested by undo or redo.
    void followExchange();
    /// Whether an undo reverts the whole scene, which it then requests.
    bool undoesScene();
    bool redoesScene();
    /// Goes to a row of the history, which may be of another scene.
    void goToChange(std::size_t done);
    /// Adds what the panels show of faults and of other scenes.
    void describeFaults();
    void browse(ui::FilePurpose purpose, BrowseFor what = BrowseFor::itself);
    void askAboutTest();
    /// Writes the session to its file, perhaps after a question; asks for a file if it has none.
    void saveSession();
    void take(const ChosenFile& chosen);
    void save(const ChosenFile& chosen);
    int savePicture(render::Image image, const std::string& name);

    /// Lists the materials again, and reports those that can't be read.
    void lookForMaterials();
    /// Gives a model a material with its look, as one change.
    void takeMaterial(const ui::TakeMaterial& wanted);
    void browseToSaveMaterial();

    // Work that must not be lost: editor_keeping.cpp.
    void keepWork(double elapsedSeconds);
    /// Saves a small picture of the scene, if due.
    void keepPicture();
    /// Offers work that a window left behind, if any.
    void offerLeftWork();
    void tellOfDriver();
    /// Drops the scene and all that concerns it.
    void leaveScene();
    /// Closes a failed scene, for the reason in `sentence`, and offers its work as left behind.
    void giveUpScene(const std::string& sentence);
    /// Whether recovered work is still being played: an action now would cut off the rest.
    bool comesBack();
    bool hasUnsavedWork() const;
    /// Does `next`, after a question about unsaved work: "WHAT without saving?"
    void askBefore(const std::string& what, const std::function<void()>& next);
    /// Asks `question`, whose choices are to save before, to proceed, and to cancel. `saved` is
    /// done once the session is saved.
    void askToSave(ui::Question question, std::function<void()> saved, std::function<void()> next);
    void leave();

    // What the panels show: editor_description.cpp.
    /// Fills in the panel model. Without `withOverlay` the lines of the coming cut are unchanged.
    void describe(bool withOverlay);
    void describeScene();
    /// The title of the window.
    std::string title() const;
};

}  // namespace kerf::app
