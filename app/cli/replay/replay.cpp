#include "app/cli/replay/replay.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "app/files/export/export.h"
#include "app/files/export/export_alembic.h"
#include "app/files/import/model_source.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/files/io/system_file.h"
#include "app/link/blade_link.h"
#include "app/scene/timeline/saved_session.h"
#include "app/session/headless_session.h"
#include "app/session/scene_origin.h"
#include "app/session/scene_view.h"
#include "app/session/task_run.h"
#include "app/session/volume_watch.h"
#include "gpu/context.h"
#include "render/renderer.h"
#include "sim/base/stopwatch.h"
#include "sim/base/text.h"
#include "sim/run/simulation.h"

namespace kerf::app {

namespace {

/// What ffmpeg has written so far, until the film is complete.
constexpr const char* kUnfinishedFilm = ".film.part";

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

/// The hashes to compare with may lie in the folder itself, so they stay.
void removeEarlierResults(OutputFolder& folder, const Session& session, bool verifies) {
    for (const char* name : {kSummaryFile, kMetricsFile, kMeshFile, kPiecesFile}) {
        folder.remove(name);
    }
    if (!verifies) {
        folder.remove(kHashesFile);
    }
    for (const SessionEvent& event : session.events) {
        if (const auto* picture = std::get_if<ScreenshotEvent>(&event.action)) {
            folder.remove(picture->file);
        } else if (const auto* mesh = std::get_if<ExportEvent>(&event.action)) {
            removeExport(folder, *mesh);
        }
    }
}

/// What a run that was killed has left of the tables.
void removeUnfinished(const OutputFolder& folder) {
    folder.remove(kUnfinishedFilm);
    for (const char* name : kReplayFiles) {
        folder.removeUnfinished(name);
    }
}

/// The tables that a replay writes step by step: metrics.csv, and optionally hashes.csv and
/// pieces.csv. They appear under their names once complete.
class RunFiles {
  public:
    /// Begins the tables. Throws OutputError, like all functions here.
    RunFiles(OutputFolder& folder, bool hashes, bool pieces);

    bool wantsHashes() const { return hashes_.has_value(); }
    bool wantsPieces() const { return pieces_.has_value(); }
    void write(const MetricsRow& row) { metrics_.write(formatMetrics(row)); }
    void write(int step, const StateHashes& hashes) { hashes_->write(formatHashes(step, hashes)); }
    void write(int step, const std::vector<Piece>& pieces, const std::vector<Bounds>& boxes,
               const Vec3& from) {
        pieces_->write(formatPieces(step, pieces, boxes, from));
    }
    /// Completes them.
    void commit();

  private:
    OutputFolder& folder_;
    AtomicFile metrics_;
    std::optional<AtomicFile> hashes_;
    std::optional<AtomicFile> pieces_;
};

void begin(std::optional<AtomicFile>& table, OutputFolder& folder, const char* name,
           const std::string& header) {
    table.emplace(folder.pathOf(name));
    table->write(header);
}

RunFiles::RunFiles(OutputFolder& folder, bool hashes, bool pieces)
    : folder_(folder), metrics_(folder.pathOf(kMetricsFile)) {
    metrics_.write(metricsHeader());
    if (hashes) {
        begin(hashes_, folder, kHashesFile, hashesHeader());
    }
    if (pieces) {
        begin(pieces_, folder, kPiecesFile, piecesHeader());
    }
}

void RunFiles::commit() {
    metrics_.commit();
    folder_.noteWritten(kMetricsFile);
    if (hashes_) {
        hashes_->commit();
        folder_.noteWritten(kHashesFile);
    }
    if (pieces_) {
        pieces_->commit();
        folder_.noteWritten(kPiecesFile);
    }
}

/// Time that a step spends on pictures and files, which belongs to no frame.
class TimeOutside {
  public:
    /// Runs `work` and returns how long it took [ms].
    template <class Work>
    double measure(Work work) {
        const Stopwatch watch;
        work();
        const double milliseconds = watch.milliseconds();
        sum_ += milliseconds;
        return milliseconds;
    }
    /// All of it since the last call [ms].
    double take() { return std::exchange(sum_, 0); }

    double pictureMs = 0;  ///< of the coming step

  private:
    double sum_ = 0;
};

/// What follows a run step by step.
struct RunWatches {
    VolumeWatch volumes;
    ForceTrace forces;
};

/// A cache, and the time of its samples.
struct CacheInWork {
    CacheInWork(const std::filesystem::path& path, const std::string& name, const Vec3& origin)
        : file(path, name, origin) {}
    AlembicCache file;
    FilmClock clock{1};
};

/// Clients who lead the blade, and all that was done.
struct LedRun {
    LedRun(const ReplayOptions& options, const Session& session, const SurfaceMesh& mesh)
        : blade(*options.link, bladeLengthOf(session).value_or(meshBounds(mesh).diagonal()),
                session.origin, options.linkBodies) {}
    BladeLink blade;
    EventLog log;
};
constexpr int kOfClient = -1;  // the number of no event

/// One run of one session, with what comes of it.
class Replay {
  public:
    /// `remarks`: those on the model. The session must not have run yet.
    Replay(HeadlessSession& running, const std::vector<std::string>& remarks, OutputFolder& folder,
           const ReplayOptions& options)
        : running_(running),
          session_(running.session()),
          options_(options),
          expected_(options.verify),
          steps_(options.link != nullptr ? options.until : std::min(session_.steps, options.until)),
          folder_(folder),
          schedule_(session_),
          files_(folder, options.hashes, options.pieces),
          path_(cameraPathOf(session_)) {
        summary_.model = session_.model.name();
        std::ranges::for_each(remarks, [&](const std::string& sentence) { remark(sentence); });
        const gpu::DeviceInfo device = gpu::queryDevice();
        summary_.renderer = device.renderer;
        summary_.driver = device.version;
        summary_.before = countBody();
        beginPictures();
        if (!options_.cache.file.empty()) {
            cache_.emplace(options_.cache.file, summary_.model, session_.origin);
        }
        if (options_.link != nullptr) {
            led_.emplace(options_, session_, simulation().mesh());
        }
        simulation().feelBlade(options_.forces || session_.task || led_);
    }

    void run(const ReplayListener& listener) {
        removeEarlierResults(folder_, session_, expected_ != nullptr);
        if (options_.sequence.every > 0) {
            sequence_.emplace(folder_, options_.sequence);
        }
        const auto isLeft = [&] { return led_ && step_ > 0 && led_->blade.isOver(); };
        for (; step_ < steps_ && !stopped_ && !isLeft(); ++step_) {
            if (listener.progress) {
                listener.progress(step_, steps_);
            }
            runStep(listener);
        }
        if (!stopped_) {
            applyActions();
            performAll(led_ ? led_->blade.lift() : std::vector<Command>());
            filmState();
            writeMeshes();
            checkLength();
        }
        remark(watches_.volumes.sentence());
        writeResults();
    }

    RunSummary takeSummary() { return std::move(summary_); }
    const std::optional<FilmReport>& filmReport() const { return filmReport_; }
    int cacheSamples() const { return cache_ ? cache_->file.samples() : 0; }

    // What happens before a step: see SimulationDriver::applyActions.
    void perform(const Command& asked, int event) {
        const bool isOfBlade =
            std::holds_alternative<MoveBlade>(asked) || std::holds_alternative<LiftBlade>(asked);
        if (led_ && isOfBlade && event != kOfClient) {
            return;  // clients lead it instead
        }
        const Command command = led_ ? asReplayed(asked, session_.origin) : asked;
        if (led_) {
            led_->log.note(step_, command);
        }
        if (film_) {
            film_->note(command);
        }
        if (cache_) {
            cache_->clock.note(command);
        }
        running_.perform(command, event);
    }
    void take(const ScreenshotEvent& event) {
        outside_.pictureMs += outside_.measure([&] {
            writePicture(running_.draw(running_.camera(), event.width, event.height),
                         folder_.pathOf(event.file));
            folder_.noteWritten(event.file);
        });
    }
    void take(const ExportEvent& event) {
        outside_.measure([&] { running_.write(event, folder_); });
    }
    void take(const CameraEvent& /*event*/) const {}  // films know all of them from the start
    void take(const MarkEvent& /*event*/) const {}
    void take(const CheckEvent& event) {
        if (!led_) {  // that is another run
            outside_.measure([&] { check(event); });
        }
    }

  private:
    // --- Clients who lead the blade
    // ---------------------------------------------------------------

    void performAll(const std::vector<Command>& commands) {
        std::ranges::for_each(commands, [&](const Command& c) { perform(c, kOfClient); });
    }

    void tellClients() {
        led_->blade.tell(simulation());
        const auto& done = led_->log.entries();
        if (!done.empty() && done.back().event.step == step_ &&
            std::holds_alternative<LiftBlade>(done.back().event.action)) {
            tellScore(scoreOf(played(), simulation(), watches_.forces));
        }
    }

    void tellScore(const std::optional<Score>& score) {
        if (led_ && score) {
            led_->blade.tell("KerfScore", toJson(*score, *session_.task).dump(-1, ' ', true));
        }
    }

    /// The session with what clients did in place of its own blade.
    Session played() const { return led_ ? sessionAsSaved(session_, led_->log).session : session_; }

    void writeRecord() {
        Session session = played();
        session.steps = step_;
        session.events.push_back(
            {step_, CheckEvent{summary_.stateHash, static_cast<int>(summary_.pieces.size())}});
        writeOutputFile(
            options_.record,
            formatSession(session, std::filesystem::absolute(options_.record).parent_path()));
    }

    // --- Steps
    // ------------------------------------------------------------------------------------

    /// Films are begun before anything is simulated: what they need may be missing.
    void beginPictures() {
        if (!options_.film.file.empty()) {
            film_.emplace(options_.film, folder_.pathOf(kUnfinishedFilm), steps_, path_);
        }
        if (!options_.strip.file.empty()) {
            strip_.emplace(options_.strip, steps_);
        }
        if (film_ || strip_ || !pictureFiles(session_).empty()) {
            running_.preparePictures();
        }
    }

    /// The state before the coming step, once that step's actions were applied.
    void filmState() {
        if (!film_ && !strip_) {
            return;
        }
        const Film::Draw draws = [this](const render::Camera& camera, const PictureSize& size) {
            return running_.draw(camera, size.width, size.height);
        };
        outside_.pictureMs += outside_.measure([&] {
            const double time = simulation().report().time;
            if (film_) {
                film_->show(step_, time, running_.camera(), draws);
            }
            if (strip_) {
                strip_->show(step_, time, path_.empty() ? running_.camera() : path_.at(step_),
                             draws);
            }
        });
    }

    /// The same state as meshes.
    void writeMeshes() {
        const bool ends = stopped_ || step_ == steps_;
        if (sequence_ && sequence_->wants(step_, ends ? step_ : steps_)) {
            outside_.measure([&] {
                sequence_->write(step_, simulation().report().time, simulation().mesh(),
                                 simulation().pieces(), {{}, lookOf(session_)}, session_.origin);
            });
        }
        if (cache_ && step_ % options_.cache.every == 0) {
            outside_.measure([&] {
                cache_->file.add(
                    cache_->clock.elapsed(),
                    gatherMesh(simulation().mesh(), simulation().pieces(), running_.exportLooks()),
                    simulation().timeRuns());
            });
        }
    }

    void finishFilms() {
        if (sequence_) {
            sequence_->finish();
        }
        if (cache_) {
            cache_->file.finish();
        }
        if (film_) {
            filmReport_ = film_->finish();
        }
        if (strip_) {
            const Params& params = session_.params;
            const bool isAuto = params.iterations == kAutoIterations;
            strip_->finish(fmt::format("{}: time step {} s, {} iterations", summary_.model,
                                       params.timeStep,
                                       isAuto ? "auto" : std::to_string(params.iterations)));
        }
    }

    void runStep(const ReplayListener& listener) {
        const Stopwatch watch;
        applyActions();
        if (led_) {
            outside_.measure(
                [&] { performAll(led_->blade.await(simulation().params().timeStep)); });
        }
        filmState();
        writeMeshes();
        if (stopped_) {
            return;
        }
        const StepReport& report = running_.step();
        if (film_) {
            film_->pass(simulation().params().timeStep, simulation().timeRuns());
        }
        if (cache_) {
            cache_->clock.pass(simulation().params().timeStep, simulation().timeRuns());
        }
        const double outsideMs = outside_.take();
        const MetricsRow row{
            report, std::exchange(outside_.pictureMs, 0), watch.milliseconds() - outsideMs,
            namesToughness(session_, simulation().params()), secondsOfStep(simulation())};
        publish(row, listener);
    }

    /// After a step: what is written and told of it.
    void publish(const MetricsRow& row, const ReplayListener& listener) {
        files_.write(row);
        watches_.forces.add(row.report, simulation().params().timeStep);
        summary_.statistics.add(row);
        if (!row.report.open) {
            watches_.volumes.add(step_, simulation().measuredPieces());
        }
        if (files_.wantsPieces()) {
            files_.write(step_, simulation().measuredPieces(), simulation().pieceBounds(),
                         session_.origin);
        }
        if (files_.wantsHashes() || expected_ != nullptr) {
            publish(simulation().stateHashes());
        }
        for (const std::string& problem : running_.driver().newlyBroken(row.report)) {
            fail(problem);
        }
        logMessages();
        if (led_) {
            outside_.measure([&] { tellClients(); });
        }
        if (listener.row) {
            listener.row(row);
        }
    }

    void publish(const StateHashes& hashes) {
        if (files_.wantsHashes()) {
            files_.write(step_, hashes);
        }
        if (expected_ != nullptr) {
            verify(hashes);
        }
    }

    // --- What must hold
    // ---------------------------------------------------------------------------

    /// All that comes behind the first difference follows from it, so nothing is compared any more.
    void verify(const StateHashes& hashes) {
        const bool known = step_ < expected_->steps();
        const auto parts =
            known ? expected_->differingParts(step_, hashes) : std::vector<std::string>{};
        if (!known) {
            diverge(options_.verifyName + " ends before this step");
        } else if (!parts.empty()) {
            diverge("the replay has diverged from " + options_.verifyName + " in " +
                    enumerated(parts));
        }
        if (!known || !parts.empty()) {
            expected_ = nullptr;
        }
    }

    /// All steps of the session ran, so the other run must be over as well.
    void checkLength() {
        if (expected_ != nullptr && steps_ == session_.steps && expected_->steps() > steps_) {
            diverge(options_.verifyName + " goes on to step " +
                    std::to_string(expected_->steps() - 1));
        }
    }

    void check(const CheckEvent& event) {
        for (const std::string& problem : running_.problemsWith(event, options_.hashChecks)) {
            diverge(problem);
        }
    }

    /// The run has become another one than it should be.
    void diverge(const std::string& problem) {
        fail(problem);
        stopped_ = stopped_ || !options_.keepGoing;
    }

    void fail(const std::string& problem) {
        summary_.failures.push_back("Step " + std::to_string(step_) + ": " + problem + ".");
    }

    // --- Actions and results
    // ----------------------------------------------------------------------

    void applyActions() { running_.driver().applyActions(schedule_, *this); }

    /// What no check fails for, but a reader of the results should know.
    void remark(const std::string& sentence) {
        if (!sentence.empty()) {
            summary_.remarks.push_back(sentence);
            spdlog::warn("{}{}", running_.filePrefix(), sentence);
        }
    }

    void logMessages() {
        for (const std::string& message : simulation().takeMessages()) {
            spdlog::warn(message);
            summary_.messages.push_back(message);
        }
    }

    Counts countBody() {
        const StepReport& report = simulation().report();
        return {report.vertices, report.triangles, report.ispcs};
    }

    void writeResults() {
        folder_.write(kMeshFile, encodeMesh(simulation().mesh(), simulation().pieces(),
                                            MeshFormat::ply, {}, session_.origin));
        files_.commit();
        finishFilms();
        summary_.after = countBody();
        summary_.pieces = simulation().pieces().pieces;
        summary_.stateHash = simulation().stateHash();
        summary_.cuts = reportOnCuts(simulation());
        if ((led_ || steps_ == session_.steps) && !stopped_) {  // else not all of a try was played
            summary_.task = session_.task;
            summary_.score = scoreOf(played(), simulation(), watches_.forces);
            tellScore(summary_.score);
        }
        if (!options_.record.empty()) {
            writeRecord();
        }
        remark(remarkOnCrossings(simulation()));
        folder_.write(kSummaryFile, formatSummary(summary_));
    }

    Simulation& simulation() { return running_.simulation(); }

    HeadlessSession& running_;
    const Session& session_;
    const ReplayOptions& options_;
    const HashTrace* expected_;  ///< until the run differs from it
    const int steps_;
    OutputFolder& folder_;
    SessionSchedule schedule_;
    RunFiles files_;
    std::optional<Film> film_;
    std::optional<FilmReport> filmReport_;
    std::optional<FilmStrip> strip_;
    std::optional<MeshSequence> sequence_;
    std::optional<CacheInWork> cache_;
    RunWatches watches_;
    std::optional<LedRun> led_;
    const render::CameraPath path_;  ///< of films and strips
    RunSummary summary_;
    TimeOutside outside_;
    int step_ = 0;
    bool stopped_ = false;  ///< by a check that failed
};

}  // namespace

ReplayResult replaySession(const Session& session, ModelMesh model,
                           const std::filesystem::path& folder, const ReplayListener& listener,
                           const ReplayOptions& options) {
    const std::size_t undoBudget = undoesAnything(session) ? kReplayUndoBudget : 0;
    requireMemoryFor(session, model.mesh, undoBudget);
    OutputFolder output(folder);
    const FolderLock lock(folder);
    removeUnfinished(output);
    const std::vector<std::string> remarks = std::move(model.remarks);
    HeadlessSession running(session, std::move(model), undoBudget, options.quality);
    Replay replay(running, remarks, output, options);
    replay.run(listener);
    return {replay.takeSummary(), output.written(), replay.filmReport(), replay.cacheSamples()};
}

}  // namespace kerf::app
