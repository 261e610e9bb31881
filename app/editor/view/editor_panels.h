#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/storage/editor_options.h"
#include "app/editor/storage/settings_file.h"
#include "app/editor/view/experiment_board.h"
#include "render/scene/image.h"
#include "ui/interface.h"
#include "ui/plots/plot.h"

namespace kerf::app {

/// A question that waits for the person, and what is done with the choice.
struct Asked {
    ui::Question question;
    std::function<void(int choice)> answer;
};

/// The panels with what they show, and what of that is the person's choice alone: the settings,
/// the part of the time that the plots show, and the help.
struct EditorPanels {
    /// Needs a current OpenGL 4.5 context. Reads the person's settings.
    explicit EditorPanels(const EditorOptions& options);

    float displayScale;  ///< 1 = 96 dpi
    std::string device;  ///< what draws
    SettingsFile settings;
    ui::Interface interface;
    ui::PanelModel told;  ///< what the scene told of itself when it last rested
    ui::PanelModel model;
    ExperimentBoard experiments;
    std::optional<Asked> asked;
    ui::PlotView plotView;
    bool helpOpen = false;
    bool hidden = false;  ///< both side panels, whatever the settings say

    /// Scale of the panels in a picture of this size [px]: the display's times the person's choice,
    /// as far as they have room.
    float scale(int width, int height) const;
    /// Begins the model anew: with what the scene told of itself, and what is known here.
    void describe();
    /// Does what was to be done with that choice; nothing where nothing is asked.
    void answer(int choice);
    /// Lays the panels out anew with the input of one batch, in a picture of this size [px].
    /// Returns the answers of the person.
    std::vector<ui::Action> update(std::span<const ui::InputEvent> batch, int width, int height,
                                   double elapsedSeconds);
    /// The parts of such a picture that the panels hid in the last update.
    std::vector<render::PixelRect> covered(int width, int height) const;

    /// Whether a section of the left panel is open and not hidden.
    bool shows(const std::string& section) const;
    /// Opens a section of the left panel.
    void unfold(const std::string& section);
    /// Hides the side panels for as long as the program runs, or shows those again that were
    /// hidden.
    void toggle();
    /// Takes settings that the panels answer with.
    void take(ui::Settings wanted);
    /// The plots one below the other, as they are shown.
    render::Image drawPlots(std::span<const ui::PlotSpec> plots) const;

  private:
    void showOne();
};

}  // namespace kerf::app
