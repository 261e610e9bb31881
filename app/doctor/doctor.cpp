#include "app/doctor/doctor.h"

#include <spdlog/fmt/fmt.h>

#include "app/files/import/model_source.h"
#include "app/session/headless_session.h"
#include "app/session/paper_experiments.h"
#include "gpu/buffer.h"
#include "gpu/data_path.h"
#include "gpu/program.h"
#include "sim/base/containers.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr std::size_t kFirstFrames = 5;

/// A frame of a recorded cut.
struct PlayedFrame {
    double ms = 0;
    double stepMs = 0;            ///< without its picture
    double simulatedSeconds = 0;  ///< see secondsOfStep()
    bool cuts = false;            ///< the blade was down
};

std::vector<PlayedFrame> playFrames(const Session& session, double seconds) {
    const SessionSchedule schedule(session);
    HeadlessSession play(
        session, loadSessionModel(session), 0,
        gpu::queryDevice().software ? render::Quality::light : render::Quality::full);
    std::vector<PlayedFrame> frames;
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

ModelSpeed speedOf(const std::string& model, std::span<const PlayedFrame> frames) {
    ModelSpeed speed{model};
    std::vector<double> times;
    for (const PlayedFrame& frame : frames) {
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

void append(std::vector<DriverFinding>& all, std::vector<DriverFinding> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

std::vector<DriverFinding> limitFindings(const std::vector<gpu::DriverLimit>& limits) {
    return mapped(limits, [](const gpu::DriverLimit& limit) -> DriverFinding {
        return {fmt::format("Limit: {}", limit.phrase), fmt::format("{}", limit.has),
                fmt::format("at least {}", limit.needs), limit.has >= limit.needs};
    });
}

/// Runs a part. What the driver can't do is a finding, and the other parts still run.
template <class Work>
void examine(const Examination& examination, Diagnosis& diagnosis, const std::string& part,
             Work work) {
    if (examination.next) {
        examination.next(part);
    }
    try {
        work();
    } catch (const gpu::ShaderError& error) {
        diagnosis.findings.push_back({part, error.what(), "shaders that compile", false});
    } catch (const gpu::OutOfMemory& error) {
        diagnosis.findings.push_back({part, error.what(), "memory for it", false});
    }
}

}  // namespace

std::vector<ModelSpeed> modelSpeeds(double secondsEach) {
    std::vector<ModelSpeed> speeds;
    for (const PaperExperiment& experiment : paperExperiments()) {
        const std::string file = std::string("assets/sessions/") + experiment.name + ".kerf.json";
        const std::vector<PlayedFrame> frames =
            playFrames(readSession(gpu::dataPath(file)), secondsEach);
        const std::size_t skipped = std::min(kFirstFrames, frames.size());
        speeds.push_back(speedOf(experiment.name, std::span(frames).subspan(skipped)));
    }
    return speeds;
}

bool Diagnosis::right() const {
    return debugErrors == 0 && std::ranges::all_of(findings, [](const DriverFinding& finding) {
               return finding.right;
           });
}

std::string Diagnosis::verdict() const {
    if (right()) {
        return "Kerf works as it should on this driver.";
    }
    return "Kerf does not work as it should on this driver. Update it; until then start Kerf with "
           "LIBGL_ALWAYS_SOFTWARE=1, which uses the software renderer. Please report it with what "
           "kerf doctor --out writes.";
}

Diagnosis diagnose(const Examination& examination) {
    const Stopwatch watch;
    Diagnosis diagnosis;
    diagnosis.device = gpu::queryDevice();
    diagnosis.limits = gpu::driverLimits();
    append(diagnosis.findings, limitFindings(diagnosis.limits));
    gpu::takeDebugErrors();
    examine(examination, diagnosis, "Sessions",
            [&] { append(diagnosis.findings, sessionFindings()); });
    examine(examination, diagnosis, "A cut", [&] {
        CutFindings cut = cutFindings();
        append(diagnosis.findings, std::move(cut.findings));
        diagnosis.picture = std::move(cut.picture);
    });
    examine(examination, diagnosis, "Orders", [&] {
        append(diagnosis.findings, orderFindings());
        append(diagnosis.findings, formFindings());
    });
    if (examination.speeds) {
        examine(examination, diagnosis, "Speed",
                [&] { diagnosis.speeds = modelSpeeds(examination.secondsEach); });
    }
    diagnosis.debugErrors = gpu::takeDebugErrors();
    diagnosis.seconds = watch.seconds();
    return diagnosis;
}

}  // namespace kerf::app
