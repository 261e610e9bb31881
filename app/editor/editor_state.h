#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/editor.h"
#include "app/editor/editor_toast.h"
#include "app/editor/experiment_board.h"
#include "app/editor/file_browser.h"
#include "app/editor/file_preview.h"
#include "app/editor/file_saving.h"
#include "app/editor/first_steps.h"
#include "app/editor/input_queue.h"
#include "app/editor/piece_display.h"
#include "app/editor/recent_files.h"
#include "app/editor/settings_file.h"
#include "app/editor/step_clock.h"
#include "app/files/saving_queue.h"
#include "app/scene/document_loading.h"
#include "app/scene/editor_scene.h"
#include "app/tools/blade_tool.h"
#include "app/tools/camera_flight.h"
#include "app/tools/editor_camera.h"
#include "app/tools/pull_tool.h"
#include "app/tools/view_frame.h"
#include "gpu/timer.h"
#include "ui/interface.h"
#include "ui/layout.h"

namespace kerf::app {

/// Updates of the panels after the last input, for those that answer late.
inline constexpr int kSettleUpdates = 2;

/// All that an editor holds. Its functions stand in a file per concern, as the headings say.
struct Editor::State {
    explicit State(const EditorOptions& wanted)
        : options(wanted),
          clock(wanted.byTheClock),
          settingsFile(wanted.settingsFile),
          interface(settingsFile.now.theme, scale()),
          renderer(wanted.quality),
          recent(wanted.recentFiles) {
        display.quality = wanted.quality;
    }

    EditorOptions options;
    StepClock clock;
    InputQueue queue;
    SettingsFile settingsFile;
    ui::Interface interface;
    render::Renderer renderer;
    std::unique_ptr<EditorScene> scene;
    render::Camera camera;
    CameraFlight cameraFlight;
    CameraControl cameraControl;
    Vec2 pointer = Vec2::Zero();  ///< [px]
    gpu::Framebuffer picture;
    std::vector<render::PixelRect> covered;  ///< of the picture, when its scene was drawn
    ui::PanelModel model;
    ui::History noHistory;
    EditorToast toast;
    RecentFiles recent;
    std::optional<FileBrowser> browser;  ///< while a file dialog is open
    FilePreview preview;
    /// The folders in which files were looked for and written last: two, since to save beside
    /// what was opened would put results among the models.
    std::filesystem::path lastSource;
    std::filesystem::path lastTarget;
    std::unique_ptr<FileSaving> saving;
    std::vector<std::unique_ptr<FileSaving>> cancelledSavings;  ///< until their threads end
    SavingQueue savings;                                        ///< pictures and plots
    std::unique_ptr<DocumentLoading> loading;
    std::vector<std::unique_ptr<DocumentLoading>> cancelledLoadings;  ///< until their threads end
    ExperimentBoard experiments;
    PieceDisplay pieceDisplay;
    gpu::Timer sceneTimer;
    ui::PlotView plotView;
    BladeTool bladeTool;
    PullTool pullTool;
    /// A question that waits for the person, and what is done with the choice.
    struct Asked {
        ui::Question question;
        std::function<void(int choice)> answer;
    };
    std::optional<Asked> asked;
    /// The test that a dialog asks a name for gets a picture of its end.
    bool testGetsPicture = false;
    /// A screenshot that was taken while recording: the session may have its picture too.
    struct PictureOffer {
        JournalPlace place;
        int saving = 0;  ///< its number in `savings`
    };
    std::optional<PictureOffer> pictureOffer;
    bool sceneChanged = true;
    bool closing = false;
    bool helpOpen = false;
    ui::DisplaySettings display;
    bool screenshotWanted = false;
    CutWatch cutWatch;
    FirstSteps firstSteps;
    int settleUpdates = kSettleUpdates;

    // Input: editor_input.cpp.
    void takeInput(double elapsedSeconds);
    /// Updates the panels with a batch and does what they answer. `last` of this picture: what it
    /// shows is the panels' last word.
    void updatePanels(const std::vector<ui::InputEvent>& batch, double elapsedSeconds, bool last);
    void dispatch(const ui::InputEvent& event);
    void onMove(const ui::PointerMove& move);
    void onButton(const ui::ButtonChange& change);
    void onWheel(const ui::Wheel& wheel);
    void keepCameraNear();
    void onKey(ui::Key key, const ui::Modifiers& modifiers);
    void onFocusLost();
    void takeDrop(const std::vector<std::filesystem::path>& files);
    void pressInScene(const ui::Modifiers& modifiers);
    void endStroke();

    // Answers to keys and panels: editor_actions.cpp.
    void apply(const ui::Action& action);
    void perform(ui::ActionId id);
    void releaseTools();
    /// Does a command. False where that failed, which is said in the view.
    bool execute(const Command& command);
    /// Shows what came of something that was done to the body: "" or one sentence.
    void say(const std::string& problem);
    void placeBox();
    void goToChange(std::size_t done);
    void seekTo(int step);
    void removeMark(int id);
    void setTools(const ui::ToolSettings& settings);

    // The view: editor_view.cpp.
    void landCamera();
    void setDisplay(const ui::DisplaySettings& settings);

    // Plots, experiments and pieces: editor_panels.cpp.
    void keepSettings();
    void exportPlots(bool asPicture);
    void openExperiment(const std::string& name);
    void framePiece(int piece);
    void showPiece(int piece, bool visible);
    void hoverPiece(int piece);
    /// Scale of the panels: the display's times the person's choice, as far as they have room.
    float scale() const {
        return std::min(options.scale * static_cast<float>(settingsFile.now.uiScale),
                        ui::largestScale(options.width, options.height));
    }

    // Files: editor_files.cpp.
    void open(const std::filesystem::path& file, bool fillHoles = false);
    void followWork();
    void followLoading();
    void followSaving();
    void followSavings();
    bool isWorking() const { return loading != nullptr || saving != nullptr; }
    /// Whether a stroke or a pull is under way.
    bool toolIsBusy() const { return bladeTool.holds() || pullTool.holds(); }
    void cancelLoading();
    void cancelWork();
    void askAboutHoles(const ModelFault& fault);
    void show(UploadedDocument uploaded);
    ui::WorkState workState() const;
    void saveSession(const std::filesystem::path& file);
    void saveRecording();
    void beginTest();
    void saveTest(const std::filesystem::path& file);
    void exportBody(const std::filesystem::path& file, bool filePerPiece);
    bool startsSaving();

    // The file dialog: editor_file_dialog.cpp.
    void browse(ui::FilePurpose purpose);
    void applyToFiles(const ui::FileAction& action);
    void takeFile(const std::filesystem::path& file);
    void followPreview();
    void answer(int choice);
    std::filesystem::path& lastFolder(ui::FilePurpose purpose) {
        return purpose == ui::FilePurpose::open ? lastSource : lastTarget;
    }
    std::vector<ui::FolderLink> bookmarks(ui::FilePurpose purpose) const;
    void saveScreenshot();
    void saveSceneScreenshot();
    int savePicture(render::Image image, const std::string& name);
    void tellOfSaving(const SavingQueue::Outcome& outcome);

    // Time: editor_time.cpp.
    void advance(double elapsedSeconds);
    /// Runs `needed` steps whatever they cost, and up to `due` ones while they are fast.
    void runSteps(int needed, int due);
    bool running() const;

    // What the panels are told: editor_description.cpp.
    /// Fills the model. Without `withOverlay` the lines of the coming cut stay as they were.
    void describe(bool withOverlay);
    ui::Overlay overlayNow();
    Situation situation() const;
    void followFirstSteps();

    // Pictures: editor_picture.cpp.
    void draw();
    void drawScene();
    render::SceneView sceneToDraw();
    void addOverlays(render::SceneView& view) const;
    /// The bounds of the pieces as they are drawn [m].
    Bounds shownBounds(const std::vector<render::PieceLook>& looks) const;
    bool joinPieces();
    render::BodyLook ownLook() const;
    std::vector<render::PixelRect> coveredPixels() const;
    void ensurePicture();

    ViewFrame viewFrame() const { return {camera, options.width, options.height}; }
};

}  // namespace kerf::app
