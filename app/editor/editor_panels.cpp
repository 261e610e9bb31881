#include <spdlog/spdlog.h>

#include "app/editor/editor_state.h"
#include "app/editor/plot_export.h"
#include "app/files/file_io.h"
#include "app/files/free_file.h"
#include "gpu/data_path.h"
#include "ui/plot_picture.h"
#include "ui/plots_panel.h"

namespace kerf::app {
namespace {

constexpr int kPlotPictureWidth = 1200;  // [px]
constexpr int kPlotPictureHeight = 300;  // of each plot [px]

}  // namespace

/// Once a drag of an edge is over, not at each of its moves.
void Editor::State::keepSettings() {
    if (interface.isDragging()) {
        return;
    }
    if (const std::string problem = settingsFile.save(); !problem.empty()) {
        spdlog::error("{}", problem);
        toast.show(problem, true);
    }
}

/// Drawn here, since that needs OpenGL; encoded and written behind.
void Editor::State::exportPlots(bool asPicture) {
    const std::vector<ui::PlotSpec> plots = ui::chosenPlots(model);
    if (plots.empty()) {
        toast.show("No plot is chosen that could be saved.", true);
        return;
    }
    const auto save = [this](const char* ending, auto write) {
        savings.add([folder = options.screenshotFolder, ending, write = std::move(write)] {
            const std::filesystem::path file = freeFile(folder, "kerf-plots", ending);
            write(file);
            return "Saved " + file.string();
        });
    };
    if (asPicture) {
        const int height = kPlotPictureHeight * static_cast<int>(plots.size());
        save(".png", [picture = ui::PlotPainter(settingsFile.now.theme)
                                    .draw(plots, plotView, kPlotPictureWidth, height)](
                         const std::filesystem::path& file) { writePicture(picture, file); });
    } else {
        save(".csv", [text = formatPlots(plots)](const std::filesystem::path& file) {
            writeOutputFile(file, text);
        });
    }
}

void Editor::State::openExperiment(const std::string& name) {
    open(gpu::dataPath("assets/sessions/" + name + ".kerf.json"));
}

void Editor::State::framePiece(int piece) {
    const std::vector<Bounds>* boxes =
        scene == nullptr ? nullptr : &scene->simulation().pieceBounds();
    const auto index = static_cast<std::size_t>(piece);
    if (boxes != nullptr && piece >= 0 && index < boxes->size() && !(*boxes)[index].empty()) {
        render::Camera wanted = cameraFlight.destination(camera);
        wanted.frame((*boxes)[index]);
        cameraFlight.start(camera, wanted);
    }
}

void Editor::State::showPiece(int piece, bool visible) {
    if (piece >= 0) {
        pieceDisplay.show(piece, visible);
        sceneChanged = true;
    }
}

void Editor::State::hoverPiece(int piece) {
    sceneChanged = pieceDisplay.hover(piece) || sceneChanged;
}

}  // namespace kerf::app
