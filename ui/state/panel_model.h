#pragma once

#include <string>
#include <vector>

#include "ui/base/settings.h"
#include "ui/state/body_state.h"
#include "ui/state/change_list.h"
#include "ui/state/cuts_state.h"
#include "ui/state/display_settings.h"
#include "ui/state/experiment_card.h"
#include "ui/state/file_dialog_state.h"
#include "ui/state/help_state.h"
#include "ui/state/log_line.h"
#include "ui/state/looks_state.h"
#include "ui/state/model_state.h"
#include "ui/state/overlay.h"
#include "ui/state/parameters_state.h"
#include "ui/state/pieces_state.h"
#include "ui/state/plots_state.h"
#include "ui/state/question.h"
#include "ui/state/session_state.h"
#include "ui/state/toast_state.h"
#include "ui/state/tool_settings.h"
#include "ui/state/transport_state.h"
#include "ui/state/view_axes.h"
#include "ui/state/work_state.h"

namespace kerf::ui {

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
