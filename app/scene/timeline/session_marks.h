#pragma once

#include <string>
#include <vector>

#include "app/files/import/model_faults.h"
#include "app/scene/timeline/session_journal.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The pictures, exports and checks of a journal, as the panels list them. Those that a recording
/// makes of itself are left out.
std::vector<ui::SessionMark> marksOf(const SessionJournal& journal);

/// The strokes of a journal, each at its first pose, and its changes of parameters. Of changes at
/// one step of one parameter the last counts.
std::vector<ui::SessionMark> courseOf(const SessionJournal& journal);

/// NAME-STEP with an ending (".png"), numbered where an event of the journal writes a file of that
/// name already.
std::string freeOutputName(const SessionJournal& journal, const std::string& name, int step,
                           const std::string& ending);

}  // namespace kerf::app
