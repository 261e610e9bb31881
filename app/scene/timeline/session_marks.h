#pragma once

#include "app/files/import/model_faults.h"
#include "app/scene/timeline/event_log.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The pictures, exports and checks of a log for the panels, without those of a recording.
std::vector<ui::SessionMark> marksOf(const EventLog& log);

/// What was done in a log, by step: strokes that met the body, or may meet it, each at its
/// first pose, hands, pins, boxes, placements and parameters. Of several changes of one thing at a
/// step, the last.
std::vector<ui::SessionMark> pastMarks(const EventLog& log);

/// NAME-STEP with an ending (".png"), numbered if an event of the log already writes that file.
std::string freeOutputName(const EventLog& log, const std::string& name, int step,
                           const std::string& ending);

}  // namespace kerf::app
