#include "bench/lab/experiment/paper_session.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "app/files/io/errors.h"
#include "gpu/data_path.h"

namespace kerf::app {

namespace {

constexpr int kPictureHeight = 360;

/// As the paper solves, answers contact and cuts.
void solveAsPublished(Params& params) {
    params.solver = SolverMode::pbd;
    params.paperContact = 1;
    params.openCut = 1;
}

template <class Event>
bool holds(const SessionEvent& event) {
    return std::holds_alternative<Event>(event.action);
}

bool setsGravity(const SessionEvent& event) {
    const auto* set = std::get_if<SetParam>(&event.action);
    return set != nullptr && set->name == "gravity";
}

template <class Wanted>
int stepOf(const Session& session, Wanted wanted, const char* what) {
    const auto found = std::ranges::find_if(session.events, wanted);
    if (found == session.events.end()) {
        throw InputError(session.fileName + ": an experiment needs " + what + ".");
    }
    return found->step;
}

std::string fileOf(int step) {
    return fmt::format("pictures/step-{:03}.png", step);
}

ReportPicture pictureAt(int step, std::string caption) {
    return {step, fileOf(step), std::move(caption)};
}

/// The steps of the session's own pictures from a step on, by time.
std::vector<int> pictureStepsFrom(const Session& session, int first) {
    std::vector<int> steps;
    for (const SessionEvent& event : session.events) {
        if (holds<ScreenshotEvent>(event) && event.step >= first) {
            steps.push_back(event.step);
        }
    }
    std::ranges::sort(steps);
    return steps;
}

void sortEvents(Session& session) {
    std::ranges::stable_sort(session.events, {}, &SessionEvent::step);
}

}  // namespace

Moments momentsOf(const Session& session) {
    return {stepOf(session, holds<MoveBlade>, "a stroke of the blade"),
            stepOf(session, holds<LiftBlade>, "a blade that is lifted"),
            stepOf(session, setsGravity, "gravity that begins to act"), session.steps};
}

std::vector<ReportPicture> cuttingPictures(const Session& session) {
    const Moments at = momentsOf(session);
    const std::vector<int> landed = pictureStepsFrom(session, at.gravity);
    const int impact = landed.empty() ? at.end : landed.front();
    return {pictureAt(at.blade, "before the cut"), pictureAt((at.blade + at.lift) / 2, "half way"),
            pictureAt(at.lift + 1, "cut through"),
            pictureAt((at.gravity + 2 * impact) / 3, "falling")};
}

std::vector<ReportPicture> fallPictures(const Session& session) {
    std::vector<ReportPicture> pictures;
    for (const int step : pictureStepsFrom(session, momentsOf(session).gravity)) {
        pictures.push_back(pictureAt(step, pictures.empty()        ? "at the impact"
                                           : step == session.steps ? "at the end"
                                                                   : "afterwards"));
    }
    return pictures;
}

Session paperSession(const PaperExperiment& experiment, bool published) {
    Session session = readSession(
        gpu::dataPath("assets/sessions/" + std::string(experiment.name) + ".kerf.json"));
    for (const std::string& warning : session.warnings) {
        spdlog::warn(warning);
    }
    if (published) {
        solveAsPublished(session.params);
    }
    return session;
}

Session withPictures(Session session, const std::vector<ReportPicture>& pictures, int width) {
    for (const ReportPicture& picture : pictures) {
        session.events.push_back(
            {picture.step, ScreenshotEvent{picture.file, width, kPictureHeight}});
    }
    sortEvents(session);
    return session;
}

void sizePictures(Session& session, int width) {
    for (SessionEvent& event : session.events) {
        if (auto* picture = std::get_if<ScreenshotEvent>(&event.action)) {
            picture->width = width;
            picture->height = kPictureHeight;
        }
    }
}

Session strokeAlone(Session session) {
    session.steps = momentsOf(session).lift + 1;
    std::erase_if(session.events, [&](const SessionEvent& event) {
        return holds<ScreenshotEvent>(event) || holds<CheckEvent>(event) ||
               event.step > session.steps;
    });
    return session;
}

Session figure2Session(bool published, double ispcStiffness, const std::string& file) {
    Session session = paperSession(*findPaperExperiment(kFigure2Model), published);
    session.steps = kFigure2Steps;
    session.params.ispcStiffness = ispcStiffness;
    std::erase_if(session.events, [&](const SessionEvent& event) {
        return holds<ScreenshotEvent>(event) || event.step > session.steps;
    });
    return withPictures(std::move(session), {{kFigure2Step, file, ""}}, kFallWidth);
}

}  // namespace kerf::app
