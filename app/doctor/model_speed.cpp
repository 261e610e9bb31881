#include "app/doctor/model_speed.h"

#include <algorithm>
#include <span>

#include "app/files/import/model_source.h"
#include "app/session/headless_session.h"
#include "app/session/paper_experiments.h"
#include "gpu/context.h"
#include "gpu/data_path.h"
#include "gpu/program.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr std::size_t kFirstFrames = 5;

/// A frame of a recorded cut.
struct Frame {
    double ms = 0;
    double stepMs = 0;            ///< without its picture
    double simulatedSeconds = 0;  ///< see secondsOfStep()
    bool cuts = false;            ///< the blade was down
};

std::vector<Frame> playFrames(const Session& session, double seconds) {
    const SessionSchedule schedule(session);
    HeadlessSession play(
        session, loadSessionModel(session), 0,
        gpu::queryDevice().software ? render::Quality::light : render::Quality::full);
    std::vector<Frame> frames;
    const Stopwatch all;
    while (play.simulation().stepCount() < session.steps && all.seconds() < seconds) {
        const Stopwatch watch;
        play.stepBy(schedule);
        const double stepMs = watch.milliseconds();
        play.show(play.camera(), kWidth, kHeight);
        gpu::finish();
        frames.push_back({watch.milliseconds(), stepMs, secondsOfStep(play.simulation()),
                          play.simulation().blade().has_value()});
    }
    return frames;
}

ModelSpeed speedOf(const std::string& model, std::span<const Frame> frames) {
    ModelSpeed speed{model};
    std::vector<double> times;
    for (const Frame& frame : frames) {
        times.push_back(frame.ms);
        speed.realTime.add(frame.simulatedSeconds, frame.stepMs, frame.ms - frame.stepMs);
        speed.worstCutMs = std::max(speed.worstCutMs, frame.cuts ? frame.ms : 0);
    }
    speed.frames = static_cast<int>(times.size());
    if (!times.empty()) {
        const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
        std::nth_element(times.begin(), middle, times.end());
        speed.medianMs = *middle;
    }
    return speed;
}

}  // namespace

std::vector<ModelSpeed> modelSpeeds(double secondsEach) {
    std::vector<ModelSpeed> speeds;
    for (const PaperExperiment& experiment : paperExperiments()) {
        const std::string file = std::string("assets/sessions/") + experiment.name + ".kerf.json";
        const std::vector<Frame> frames = playFrames(readSession(gpu::dataPath(file)), secondsEach);
        const std::size_t skipped = std::min(kFirstFrames, frames.size());
        speeds.push_back(speedOf(experiment.name, std::span(frames).subspan(skipped)));
    }
    return speeds;
}

}  // namespace kerf::app
