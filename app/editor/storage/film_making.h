#pragma once

#include <filesystem>

#include "app/files/jobs/work_progress.h"
#include "app/session/session.h"
#include "ui/state/file_dialog_state.h"

namespace kerf::app {

/// Makes a film of a session by a replay in a separate process; the extension of `file` is one of
/// filmFormats(). The film appears complete or not at all. Throws OutputError, and WorkCancelled.
void filmSession(const Session& session, const std::filesystem::path& file,
                 const ui::FilmLook& look, WorkProgress& progress);

}  // namespace kerf::app
