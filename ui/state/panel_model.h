#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/math.h"
#include "ui/base/settings.h"
#include "ui/plots/history.h"
#include "ui/plots/plot_math.h"
#include "ui/state/body_state.h"
#include "ui/state/change_list.h"
#include "ui/state/cuts_state.h"
#include "ui/state/display_settings.h"
#include "ui/state/experiment_card.h"
#include "ui/state/file_dialog_state.h"
#include "ui/state/help_state.h"
#include "ui/state/looks_state.h"
#include "ui/state/model_state.h"
#include "ui/state/overlay.h"
#include "ui/state/parameters_state.h"
#include "ui/state/piece_row.h"
#include "ui/state/question.h"
#include "ui/state/session_state.h"
#include "ui/state/toast_state.h"
#include "ui/state/tool_settings.h"
#include "ui/state/transport_state.h"
#include "ui/state/work_state.h"

namespace kerf::ui {

/// One line of the log.
struct LogLine {
    std::string text;
    bool isError = false;
};

/// What the list of pieces shows.
struct PiecesState {
    std::vector<PieceRow> rows;
    int hovered = -1;  ///< of rows; -1 for none
};

/// What the plots show.
struct PlotsState {
    const History* history = nullptr;  ///< never null while panels are drawn
    std::optional<RunFigures> paper;   ///< of the open experiment, if in the paper
    PlotView view;
};

/// The world's axes in the view: x to the right, y up, z towards the viewer; unit.
struct ViewAxes {
    std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
};

/// The content of the view besides the scene.
struct ViewState {
    Overlay overlay;  ///< of the coming cut
    ViewAxes axes;
    bool orthographic = false;
    std::vector<MeasureRow> measures;  ///< oldest first
    std::string device;                ///< what draws: "llvmpipe"
};

/// The content of all panels, a part for each: filled by the editor every frame, read only here.
struct PanelModel {
    std::string name;  ///< of the open document; empty for none
    ModelPanelState model;
    ParametersState parameters;
    BodyState body;
    TransportState transport;
    ChangeList changes;
    ToolSettings tools;
    ViewState view;
    SessionPanelState session;
    DisplaySettings display;
    LooksState looks;
    HelpState help;
    WorkState work;
    FileDialogState files;
    Question question;
    ToastState toast;
    std::vector<LogLine> log;  ///< oldest first
    CutsState cuts;
    PiecesState pieces;
    std::vector<ExperimentCard> experiments;
    PlotsState plots;
    Settings settings;
};

}  // namespace kerf::ui
