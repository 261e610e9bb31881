#pragma once

#include "app/editor/steps/step_clock.h"
#include "app/editor/storage/editor_options.h"
#include "app/editor/storage/settings_file.h"
#include "app/editor/view/practice.h"
#include "render/scene/image.h"
#include "ui/interface.h"
#include "ui/plots/plot.h"
#include "ui/state/panel_model.h"
#include "ui/state/window_state.h"

namespace kerf::app {

class EditorScene;

/// The paper's experiments with its figures and our measurements: of the open run, or of the last
/// one in this window.
class ExperimentBoard {
  public:
    /// Takes the figures of the scene, if it is one of the experiments.
    void note(const EditorScene& scene);
    /// Sets the cards, and the paper's figures for the open experiment; `scene` may be null.
    void describe(const EditorScene* scene, ui::PanelModel& model) const;

  private:
    struct Run {
        ui::RunFigures figures;
        int triangles = 0;
    };
    std::map<std::string, Run, std::less<>> runs_;  ///< by the experiment's name
};

/// An open question to the user, and the handler of the choice.
struct Asked {
    ui::Question question;
    std::function<void(int choice)> answer;
    std::function<void(double number)> takeNumber = nullptr;  ///< before that; may be null
};

/// The panels with their content, and the user's choices: the settings, the time range of the
/// plots, and the help.
struct EditorPanels {
    /// Needs a current OpenGL 4.5 context. Reads the user's settings.
    explicit EditorPanels(const EditorOptions& options);

    float displayScale;  ///< 1 = 96 dpi
    std::string device;  ///< what draws
    std::string driver;  ///< its full name
    SettingsFile settings;
    ui::Interface interface;
    ui::PanelModel told;  ///< the scene's report when it last rested
    ui::PanelModel model;
    ExperimentBoard experiments;
    Practice practice;
    TimeLeft timeLeft;  ///< of the work that is shown
    std::optional<Asked> asked;
    ui::PlotView plotView;
    bool helpOpen = false;
    bool commandsOpen = false;  ///< the box that finds them
    bool startOpen = false;     ///< the start page
    bool hidden = false;        ///< both side panels, overriding the settings

    /// Scale of the panels in a frame of this size [px]: the display's times the user's, as far as
    /// there is room.
    float scale(int width, int height) const;
    /// Restarts the model with the scene's description and what is known here.
    void describe();
    /// Handles that choice, and the number that came with it; does nothing without a question.
    void answer(int choice, double number);
    /// Lays the panels out with the input of one batch, in a frame of this size [px]. Returns the
    /// user's actions.
    std::vector<ui::Action> update(std::span<const ui::InputEvent> batch, int width, int height,
                                   double elapsedSeconds);
    /// The parts of such a frame that the panels covered in the last update.
    std::vector<render::PixelRect> covered(int width, int height) const;

    /// Whether a section of the left panel is open and not hidden.
    bool shows(const std::string& section) const;
    /// Opens a section of the left panel.
    void unfold(const std::string& section);
    /// Hides the side panels until the program ends, or shows them again.
    void toggle();
    /// Takes settings from the panels.
    void take(ui::Settings wanted);
    /// The plots one below the other, as they are shown.
    render::Image drawPlots(std::span<const ui::PlotSpec> plots) const;

  private:
    void showOne();
};

/// The scenes of the start page, in its order, with their pictures, which are read once.
std::shared_ptr<const std::vector<ui::StartCard>> startCards();
/// The session of a scene, in assets/start; its picture lies beside it.
std::filesystem::path startSession(const std::string& name);

}  // namespace kerf::app
