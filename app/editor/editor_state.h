#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/editor.h"
#include "app/editor/steps/kernel_preparation.h"
#include "app/editor/steps/rest_depths.h"
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
#include "app/editor/view/experiment_board.h"
#include "app/editor/view/first_steps.h"
#include "app/editor/view/input_queue.h"
#include "app/editor/view/redraw.h"
#include "app/scene/document/faulty_scene.h"

namespace kerf::app {

/// The parts of an editor, and what joins several of them. The functions stand in a file per
/// concern, as the headings say.
struct Editor::State {
    explicit State(const EditorOptions& options)
        : drawsAll(options.drawsAll),
          kernels(options.warmsUp),
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

    const bool drawsAll;         ///< see EditorOptions
    gpu::ProgramShelf programs;  ///< from document to document; outlives what is made of them
    KernelPreparation kernels;
    InputQueue queue;
    Redraw redraw;
    StepClock clock;
    EditorPanels panels;
    EditorPicture picture;
    SceneAtWork scene;      ///< null while nothing is open
    SceneSteps sceneSteps;  ///< the scenes before and after it
    /// An exchange that undo or redo asked for, to be done between two steps.
    enum class Exchange { none, back, forth };
    Exchange exchangeWanted = Exchange::none;
    std::deque<ui::Action> waiting;  ///< for the scene to be done with what it does
    ui::PanelModel told;             ///< what the scene told of itself when it last rested
    double renderMs = 0;             ///< that the scene of the last picture took to draw
    Stopwatch sincePicture;
    EditorView view;
    EditorToast toast;
    NewcomerGuide guide;
    ExperimentBoard experiments;
    FileChooser chooser;
    MaterialShelf materials;
    FileWork work;
    WorkKeeping keeping;
    LeftWorkOffers offers;
    DriverCheck driverCheck;
    /// A question that waits for the person, and what is done with the choice.
    struct Asked {
        ui::Question question;
        std::function<void(int choice)> answer;
    };
    std::optional<Asked> asked;
    /// A model that can't be cut as it is, in the view instead of the scene.
    struct Faulty {
        ModelFault fault;
        OpeningOrder order;
        FaultyScene scene;
        EditorCamera before;  ///< the camera of what is open
    };
    std::optional<Faulty> faulty;
    /// The model that is open was mended as it was opened: why, how it is opened, and what was
    /// done.
    struct Mended {
        ModelFault fault;
        OpeningOrder order;
        std::string change;
    };
    std::optional<Mended> mended;
    std::optional<Mended> beingMended;  ///< the same of what is being opened
    /// What comes after the session is saved that the dialog asks a name for, or that is being
    /// saved.
    std::function<void()> afterSaving;
    /// What comes once the file is there that is being saved; may be null.
    std::function<void()> onceSaved;
    RestDepths depths;
    bool comingBack = false;  ///< see comesBack()
    bool screenshotWanted = false;
    bool closing = false;

    // A picture: editor.cpp.
    /// One picture, as Editor::frame() makes it.
    void makePicture(double elapsedSeconds);
    /// Works, and gives the scene up where memory runs out.
    void sparingly(const std::function<void()>& doWork);
    void advance(double elapsedSeconds);
    /// Begins the steps that are due, if any.
    void beginSteps();
    /// Does what waits for the scene, as far as that takes no longer than a portion.
    void workOff();
    /// Goes on with what the scene is doing.
    void goOn();
    void showMessages();
    /// Says what went wrong, in the log too.
    void complain(const std::string& sentence);
    /// Scene and panels.
    void draw();
    void drawScene();
    void saveScreenshot();
    /// Writes the settings where they have changed, once a drag is over and not at each of its
    /// moves.
    void keepSettings();

    /// Compiles on where nobody waits.
    void prepareKernels(double elapsedSeconds);

    // Input: editor_input.cpp.
    void takeInput(double elapsedSeconds);
    /// Updates the panels with a batch and does what they answer. `last` of this picture: what it
    /// shows is the panels' last word.
    void updatePanels(const std::vector<ui::InputEvent>& batch, double elapsedSeconds, bool last);
    void dispatch(const ui::InputEvent& event);
    void onButton(const ui::ButtonChange& change);
    void onKey(ui::Key key, const ui::Modifiers& modifiers);
    bool pointsAtView() const;
    /// The scene once what it does is done.
    BusyScene restingScene() { return {scene.get(), false}; }
    /// That for a tool that is to let go: it waits where it holds the body.
    BusyScene sceneOfTool() { return view.tools.holdsBody() ? restingScene() : scene.meanwhile(); }
    /// The scene for the tool in hand: one that leads the blade doesn't wait for it.
    BusyScene sceneInHand(bool presses = false);

    // Answers to keys and panels: editor_actions.cpp.
    /// Does what was asked for, at once or once the scene is done with what it does.
    void apply(const ui::Action& action);
    void answer(const ui::Action& action);
    void perform(ui::ActionId id);
    /// Does a command to the open body. False where that failed, which is said in the view.
    bool execute(const Command& command);
    /// Shows what came of something that was done to the body: "" or one sentence.
    void say(const std::string& problem);

    // Files: editor_files.cpp.
    void open(const std::filesystem::path& file) { open(orderOf(file)); }
    /// The same, after a question about work that is not saved. A material is taken at once.
    void openAsked(const std::filesystem::path& file);
    void open(OpeningOrder order, const Mending& mending = {});
    /// Opens the scene with the model of a file added, or with one of its models taken out.
    void addModel(const std::filesystem::path& file);
    void removeModel(int model);
    void openScene(OpeningOrder order);
    void show(UploadedDocument uploaded);
    /// What follows where another scene is open than before.
    void beginScene();
    void followFiles();
    /// Places a model: a large one is prepared behind the scene first.
    void place(const Place& command);
    void followPlacing();
    void followOpening();
    void askAboutMending(const ModelFault& fault, const OpeningOrder& order);

    // Faults, and what is done about them: editor_faults.cpp.
    /// Shows a model with its faults instead of the scene, as far as they are known.
    void showFaulty(const ModelFault& fault, const OpeningOrder& order);
    /// Shows the scene again.
    void hideFaulty();
    /// Begins to exchange a model for one with even triangles, after a question where it was cut.
    void remesh(const ui::Remesh& wanted);
    /// Shows what is told of what was opened, and offers to remesh a model whose skin is coarse.
    void tellOfModel(std::string note);
    void unitePieces(int model);
    /// Exchanges the only model for one for each object of its file.
    void partModel();
    /// Opens the scene anew with `model` of `start`, as a change that undo takes back.
    void exchangeModel(const Session& start, const ModelReference& model, const std::string& doing,
                       const std::string& change);
    /// The scene with even triangles is there: it takes the place of the one before, which is kept.
    void exchange(UploadedDocument uploaded, const std::string& change);
    /// Does an exchange that undo or redo asked for.
    void followExchange();
    /// Whether an undo takes the whole scene back, which it asks for then.
    bool undoesScene();
    bool redoesScene();
    /// Undoes the repair of the model as it was opened: it stands there with its faults again.
    void askAboutRepair();
    /// Nothing is open then, and nothing is kept.
    void closeScene();
    /// Goes to a row of the history, which may be of another scene.
    void goToChange(std::size_t done);
    /// The rows of the history that stand before those of the scene.
    std::size_t rowsBefore() const { return sceneSteps.rowsBefore() + (mended ? 1 : 0); }
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

    /// Takes note of the end of a saving.
    void onSaved(const SavingQueue::Outcome& outcome);

    // Work that must not be lost: editor_keeping.cpp.
    void keepWork(double elapsedSeconds);
    /// Keeps a small picture of the scene, where one is due.
    void keepPicture();
    /// Asks what becomes of what a window left behind, if there is any.
    void offerLeftWork();
    void tellOfDriver();
    void goOnFrom(const LeftWork& left);
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
    ui::WorkState sceneWork() const;
    /// The legend of the colours, with the value under the pointer where the scene rests.
    ui::FieldLegend fieldLegend(bool inView);
    /// The title of the window.
    std::string title() const;
};

}  // namespace kerf::app
