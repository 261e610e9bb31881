#pragma once

#include "app/files/export/export.h"
#include "app/files/jobs/background_job.h"
#include "app/scene/document/editor_document.h"
#include "app/scene/timeline/checkpoints.h"
#include "app/scene/timeline/saved_session.h"
#include "app/session/material.h"
#include "sim/run/simulation.h"
#include "ui/plots/plot.h"
#include "ui/state/file_dialog_state.h"

namespace kerf::app {

/// A save on a separate thread. Nothing is written once it was cancelled.
struct FileSaving : BackgroundJob<std::string> {
    /// `work` returns a message for the user. Throws OutputError.
    FileSaving(std::string what, Work work)
        : BackgroundJob(std::move(work)), title(std::move(what)) {}

    std::string title;  ///< "Exporting slice.obj"
};

/// Begins to export the present body. `look`: its displayed look.
std::unique_ptr<FileSaving> startExport(ExportTarget target, const Document& document,
                                        Simulation& simulation, const render::BodyLook& look);
/// Begins to write a session.
std::unique_ptr<FileSaving> startSaving(const std::filesystem::path& file, SavedSession saved,
                                        std::optional<SceneCheckpoint> end, const StoredEnds& ends);
/// Begins to write a material.
std::unique_ptr<FileSaving> startSavingMaterial(const std::filesystem::path& file,
                                                Material material);
/// Begins to film a session, by a replay in a separate process; as .abc or .pvd its meshes.
std::unique_ptr<FileSaving> startFilm(const std::filesystem::path& file, const ui::FilmLook& look,
                                      SavedSession saved);
/// Begins to write a session with the expectations of a run, which takes as long as that run.
std::unique_ptr<FileSaving> startSavingTest(const std::filesystem::path& file, SavedSession saved);

/// The values of plots as a CSV file, a row per value: `plot,curve,time,mean,min,max,values`. The
/// last three describe values that a long run has merged into one row.
std::string formatPlots(std::span<const ui::PlotSpec> plots);

}  // namespace kerf::app
