#pragma once

#include <string>
#include <vector>

#include "ui/axes_widget.h"
#include "ui/body_state.h"
#include "ui/boxes_panel.h"
#include "ui/changes_panel.h"
#include "ui/cuts_panel.h"
#include "ui/display_panel.h"
#include "ui/experiments_panel.h"
#include "ui/file_dialog_state.h"
#include "ui/hint.h"
#include "ui/log_panel.h"
#include "ui/model_panel.h"
#include "ui/overlay.h"
#include "ui/parameters_panel.h"
#include "ui/pieces_panel.h"
#include "ui/plots_panel.h"
#include "ui/question_box.h"
#include "ui/session_panel.h"
#include "ui/settings.h"
#include "ui/toast.h"
#include "ui/tool_settings.h"
#include "ui/transport_panel.h"
#include "ui/work_box.h"

namespace kerf::ui {

/// What is drawn into the view beside the scene.
struct ViewState {
    Overlay overlay;  ///< of the coming cut
    ViewAxes axes;
    bool orthographic = false;
    std::vector<MeasureRow> measures;  ///< oldest first
    std::string device;                ///< what draws: "llvmpipe"
};

/// All that the panels show, a part for each: filled by the editor every frame, read only here.
struct PanelModel {
    std::string name;  ///< of what is open; empty while nothing is
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
