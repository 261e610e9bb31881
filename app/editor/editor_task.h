#pragma once

#include "app/editor/editor_state.h"

namespace kerf::app {

/// Makes a task of what was cut, and begins it: a change that can be undone.
void makeTask(Editor::State& s);
/// Changes the task that is being made.
void changeTask(Editor::State& s, const ui::TaskDraft& draft);
/// Reduces a session to the task as pupils begin with it, without tries. One that passed is written
/// beside `file` as the expert's.
void leaveTask(const Editor::State& s, const std::filesystem::path& file, SavedSession& saved);

}  // namespace kerf::app
