#include "app/cli/replay.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/files/export.h"
#include "app/files/file_io.h"
#include "app/files/output_folder.h"
#include "app/session/iteration_watch.h"
#include "app/session/scene_view.h"
#include "app/session/session_runner.h"
#include "gpu/context.h"
#include "render/renderer.h"
#include "sim/base/stopwatch.h"
#include "sim/base/text.h"
#include "sim/body/rest_geometry.h"
#include "sim/run/simulation.h"

namespace kerf::app {

namespace {

/// How many pieces an earlier run had is not known: their files have no gaps.
void removeExport(OutputFolder& folder, const ExportEvent& event) {
    folder.remove(event.file);
    for (int piece = 0; event.filePerPiece; ++piece) {
        const std::string name = pieceFile(event.file, piece).generic_string();
        if (!std::filesystem::exists(folder.pathOf(name))) {
            return;
        }
        folder.remove(name);
    }
}

void removeEarlierResults(OutputFolder& folder, const Session& session) {
    for (const char* name : {kSummaryFile, kMetricsFile, kMeshFile}) {
        folder.remove(name);
    }
    for (const SessionEvent& event : session.events) {
        if (const auto* picture = std::get_if<ScreenshotEvent>(&event.action)) {
            folder.remove(picture->file);
        } else if (const auto* mesh = std::get_if<ExportEvent>(&event.action)) {
            removeExport(folder, *mesh);
        }
    }
}

bool hasPictures(const Session& session) {
    const auto isPicture = [](const SessionEvent& event) {
        return std::holds_alternative<ScreenshotEvent>(event.action);
    };
    return std::any_of(session.events.begin(), session.events.end(), isPicture);
}

/// One run of one session.
class Replay {
  public:
    Replay(const Session& session, ModelMesh model, OutputFolder& folder)
        : session_(session),
          folder_(folder),
          player_(session),
          metrics_(folder.pathOf(kMetricsFile)),
          uncut_(std::move(model.mesh)),
          uvs_(std::move(model.uvs)),
          renderer_(render::Quality::full),
          simulation_(uncut_, session.params, session.boxes),
          restBounds_(meshBounds(simulation_.mesh())),
          runner_(simulation_),
          iterations_(meanRestEdgeLength(uncut_)),
          camera_(sessionCamera(session, restBounds_)) {
        summary_.model = session.model.name();
        summary_.renderer = gpu::queryDevice().renderer;
        summary_.before = countBody();
        if (hasPictures(session)) {
            renderer_.setRestShape(simulation_.mesh());
        }
        if (undoesAnything(session)) {
            simulation_.setUndoBudget(kReplayUndoBudget);
        }
        metrics_.write(metricsHeader());
    }

    void run(const ReplayListener& listener) {
        removeEarlierResults(folder_, session_);
        for (int step = 0; step < session_.steps; ++step) {
            if (listener.progress) {
                listener.progress(step, session_.steps);
            }
            const MetricsRow row = runStep(step);
            if (listener.row) {
                listener.row(row);
            }
        }
        applyActions(session_.steps);
        remark(iterations_.sentence());
        writeResults();
    }

    RunSummary takeSummary() { return std::move(summary_); }

    // What happens before a step: see SessionRunner::applyActions.
    void perform(const Command& command, int event) {
        const std::string problem = simulation_.execute(command);
        if (!problem.empty()) {
            throw InputError(placeInFile(event) + ": " + problem);
        }
    }
    void take(const ScreenshotEvent& event) {
        const Stopwatch watch;
        renderer_.draw(sceneOf(simulation_, lookOf(session_), restBounds_, runner_.strokePoses()),
                       camera_, event.width, event.height);
        writePicture(renderer_.readPicture(), folder_.pathOf(event.file));
        folder_.noteWritten(event.file);
        renderMs_ += watch.milliseconds();
    }
    void take(const ExportEvent& event) {
        const SurfaceMesh& mesh = simulation_.mesh();
        for (const ExportedFile& file :
             encodeExport({event.file, event.filePerPiece}, mesh, simulation_.pieces(),
                          carryUvs(uncut_, uvs_, mesh))) {
            folder_.write(file.file.generic_string(), file.bytes);
        }
    }
    void take(const CheckEvent& event) {
        const CheckDifference other = runner_.compare(event);
        if (other.hash) {
            fail("the state hash is " + *other.hash + " where the session expects " + *event.hash +
                 "; the replay has diverged");
        }
        if (other.pieces) {
            fail("the model is in " + counted(*other.pieces, "piece", "pieces") +
                 " where the session expects " + std::to_string(*event.pieces));
        }
    }

  private:
    MetricsRow runStep(int step) {
        const Stopwatch watch;
        renderMs_ = 0;
        applyActions(step);
        iterations_.add(step, simulation_.params());
        const StepReport& report = runner_.step();
        const MetricsRow row{report, renderMs_, watch.milliseconds()};
        metrics_.write(formatMetrics(row));
        summary_.statistics.add(row);
        for (const std::string& problem : runner_.newlyBroken(report)) {
            fail(problem);
        }
        logMessages();
        return row;
    }

    void applyActions(int step) {
        step_ = step;
        runner_.applyActions(player_, *this);
    }

    /// "first-cut.kerf.json: events[3] at step 12", as far as it is known.
    std::string placeInFile(int event) const {
        const std::string place = event < 0 ? "" : "events[" + std::to_string(event) + "] at ";
        return filePrefix() + place + "step " + std::to_string(step_);
    }

    std::string filePrefix() const {
        return session_.fileName.empty() ? "" : session_.fileName + ": ";
    }

    void fail(const std::string& problem) {
        summary_.failures.push_back("Step " + std::to_string(step_) + ": " + problem + ".");
    }

    /// What no check fails for, but a reader of the results should know.
    void remark(const std::string& sentence) {
        if (!sentence.empty()) {
            summary_.remarks.push_back(sentence);
            spdlog::warn("{}{}", filePrefix(), sentence);
        }
    }

    void logMessages() {
        for (const std::string& message : simulation_.takeMessages()) {
            spdlog::warn(message);
        }
    }

    Counts countBody() {
        const StepReport& report = simulation_.report();
        return {report.vertices, report.triangles, report.ispcs};
    }

    void writeResults() {
        folder_.write(kMeshFile,
                      encodeMesh(simulation_.mesh(), simulation_.pieces(), MeshFormat::ply));
        metrics_.commit();
        folder_.noteWritten(kMetricsFile);
        summary_.after = countBody();
        summary_.pieces = simulation_.pieces().pieces;
        summary_.stateHash = simulation_.stateHash();
        folder_.write(kSummaryFile, formatSummary(summary_));
    }

    const Session& session_;
    OutputFolder& folder_;
    SessionPlayer player_;
    AtomicFile metrics_;
    const SurfaceMesh uncut_;
    const std::vector<CornerUvs> uvs_;  ///< of it
    render::Renderer renderer_;
    Simulation simulation_;
    Bounds restBounds_;
    SessionRunner runner_;
    IterationWatch iterations_;
    render::Camera camera_;
    RunSummary summary_;
    int step_ = 0;
    double renderMs_ = 0;
};

}  // namespace

ReplayResult replaySession(const Session& session, ModelMesh model,
                           const std::filesystem::path& folder, const ReplayListener& listener) {
    OutputFolder output(folder);
    Replay replay(session, std::move(model), output);
    replay.run(listener);
    return {replay.takeSummary(), output.written()};
}

}  // namespace kerf::app
