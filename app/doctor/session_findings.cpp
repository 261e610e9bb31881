#include <spdlog/fmt/fmt.h>

#include "app/doctor/findings.h"
#include "app/files/import/model_source.h"
#include "app/files/io/file_io.h"
#include "app/regression/judgement.h"
#include "app/session/headless_session.h"
#include "gpu/data_path.h"
#include "render/scene/picture_comparison.h"
#include "sim/base/math.h"
#include "sim/base/text.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

constexpr int kStepsBetween = 10;  // of those that are compared

// llvmpipe and zink agree to 2e-6 of the diagonal; GPUs round otherwise. First those with the
// kernels of a first stroke, for the driver's cache.
constexpr ShortSession kSessions[] = {
    {"halves", "A half on the other", 1e-3},
    {"hold", "Pinned, and in a hand", 1e-3},
    {"floor", "On the floor", 1e-3},
    {"pull", "A larger body, pulled out of shape", 1e-3},
    {"fall", "Free fall, 1 iteration a stage and then 8", 1e-4},
    {"bend", "A bent body", 1e-4},
    {"plain-pbd", "A pulled body by plain PBD", 1e-3},
    {"box", "On a box", 1e-3},
};

constexpr const char* kCutSession = "assets/sessions/sphere768.kerf.json";
constexpr int kMostCutSteps = 260;  // through the cut and the fall, onto the floor
constexpr const char* kPictureFile = "assets/doctor/cut.png";
constexpr int kPictureWidth = 640;
constexpr int kPictureHeight = 360;

std::filesystem::path fileOf(const ShortSession& session, const char* ending) {
    return gpu::dataPath(std::string("assets/doctor/") + session.name + ending);
}

/// Plays all of a session, and calls visit(play, report) after each step.
template <class Visit>
void play(const Session& session, int steps, Visit visit) {
    const SessionSchedule schedule(session);
    HeadlessSession play(session, loadSessionModel(session), 0, render::Quality::light);
    for (int step = 0; step < steps; ++step) {
        const StepReport& report = play.stepBy(schedule);
        visit(play, report);
    }
}

DriverFinding findingOf(const ShortSession& session) {
    const PieceTrace expected = readPieces(expectedPieces(session));
    const PieceTrace seen = playShortSession(session);
    const double diagonal = boxOf(expected.begin()->second, &PieceBox::box).diagonal();
    const auto distances = comparePositions(expected, seen);
    double far = 0;
    bool right = !distances.empty();
    for (const auto& [step, meters] : distances) {
        far = meters / diagonal <= far ? far : meters / diagonal;  // NaN is kept
        right = right && meters <= session.most * diagonal &&      // NaN is not
                seen.at(step).size() == expected.at(step).size();
    }
    return {
        session.check,
        fmt::format("{} at the end, {:.1g} % of the diagonal off",
                    counted(seen.empty() ? 0 : seen.rbegin()->second.size(), "piece", "pieces"),
                    100 * far),
        fmt::format("{}, at most {:.2f} %", expected.rbegin()->second.size(), 100 * session.most),
        right};
}

/// What a cut ended in.
struct CutRun {
    std::string stateHash;
    bool closed = true;     ///< after every step
    render::Image picture;  ///< of the end
};

CutRun playCut() {
    CutRun run;
    const Session session = readSession(gpu::dataPath(kCutSession));
    const int steps = std::min(session.steps, kMostCutSteps);
    play(session, steps, [&](HeadlessSession& play, const StepReport& report) {
        run.closed = run.closed && report.closed;
        if (play.simulation().stepCount() == steps) {
            run.stateHash = play.simulation().stateHash();
            run.picture = play.draw(play.camera(), kPictureWidth, kPictureHeight);
        }
    });
    return run;
}

/// The picture must be what the software renderer drew, as people see it.
DriverFinding pictureFinding(const render::Image& picture) {
    const render::PictureLimits& limits = render::kTolerantLimits;
    const render::PictureComparison comparison =
        render::comparePictures(picture, readPicture(gpu::dataPath(kPictureFile)));
    return {"Picture",
            fmt::format("{:.2f} % of its pixels differ, by {:.2f} at worst",
                        100 * comparison.shareDiffering(), comparison.worst),
            fmt::format("at most {:.0f} %, by {:.2f}", 100 * limits.pixels, limits.worst),
            render::withinLimits(comparison, limits)};
}

}  // namespace

std::span<const ShortSession> shortSessions() {
    return kSessions;
}

std::filesystem::path expectedPieces(const ShortSession& session) {
    return fileOf(session, ".csv");
}

PieceTrace playShortSession(const ShortSession& shipped) {
    const Session session = readSession(fileOf(shipped, ".kerf.json"));
    PieceTrace pieces;
    play(session, session.steps, [&](const HeadlessSession& play, const StepReport& report) {
        for (const Bounds& box : play.simulation().pieceBounds()) {
            if ((report.step + 1) % kStepsBetween == 0) {
                pieces[report.step].push_back({0, box});
            }
        }
    });
    return pieces;
}

std::vector<DriverFinding> sessionFindings(std::string_view only) {
    std::vector<DriverFinding> findings;
    for (const ShortSession& session : kSessions) {
        if (only.empty() || only == session.name) {
            findings.push_back(findingOf(session));
        }
    }
    return findings;
}

CutFindings cutFindings() {
    CutRun first = playCut();
    const CutRun second = playCut();
    CutFindings result;
    result.findings = {
        {"The surface stays closed", first.closed ? "after every step" : "not after every step",
         "after every step", first.closed},
        {"The same cut again", first.stateHash == second.stateHash ? "the same bits" : "other bits",
         "the same bits", first.stateHash == second.stateHash},
        pictureFinding(first.picture)};
    result.picture = std::move(first.picture);
    return result;
}

}  // namespace kerf::app
