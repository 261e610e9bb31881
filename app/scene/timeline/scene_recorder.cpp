#include "app/scene/timeline/scene_recorder.h"

#include "app/scene/timeline/session_marks.h"
#include "app/session/scene_origin.h"

namespace kerf::app {
namespace {

constexpr int kCheckEvery = 50;  // steps of a recording

}  // namespace

void SceneRecorder::checkNowAndThen() {
    const int step = body_.simulation.stepCount();
    if (recording_ && step % kCheckEvery == 0) {
        timeline_.log().note(step, checkOfNow());
    }
}

CheckEvent SceneRecorder::checkOfNow() {
    return {body_.simulation.stateHash(), body_.simulation.report().pieces};
}

/// Whether it is a session without events to which nobody did anything.
bool SceneRecorder::isUntouched() const {
    return body_.document.session.steps > 0 && !recorded_ && !timeline_.hasChanged();
}

SavedSession SceneRecorder::savedSession(const render::Camera& camera,
                                         const render::ChosenColors& colors, SavedAs purpose) {
    SavedSession saved = sessionAsSaved(body_.document.session, timeline_.log(), purpose);
    Session& session = saved.session;
    session.steps = stepsAsSaved();
    if (purpose == SavedAs::session && endsNow()) {
        session.events.push_back({session.steps, checkOfNow()});
    }
    setView(session, camera, colors);
    return saved;
}

std::optional<SceneCheckpoint> SceneRecorder::savedEnd() {
    const Simulation& now = body_.simulation;
    const bool ends = now.stepCount() == stepsAsSaved() && !now.blade();
    return ends ? std::optional(timeline_.now()) : std::nullopt;
}

/// With the hashes of its models, so that other files of their names are noticed later.
Session SceneRecorder::sessionWithoutEvents(const render::Camera& camera,
                                            const render::ChosenColors& colors) const {
    const Session& opened = body_.document.session;
    const auto& read = body_.document.read;
    const auto addHash = [&](ModelReference& model) {
        if (const auto file = read.find(model.file()); model.sha256.empty() && file != read.end()) {
            model.sha256 = file->second.sha256;
        }
    };
    Session session;
    session.origin = opened.origin;
    session.model = opened.model;
    session.placement = opened.placement;
    session.moreModels = opened.moreModels;
    session.params = opened.params;
    session.boxes = opened.boxes;
    session.view = opened.view;
    session.steps = stepsAsSaved();
    addHash(session.model);
    for (FurtherModel& further : session.moreModels) {
        addHash(further.model);
    }
    setView(session, camera, colors);
    return session;
}

SessionChange SceneRecorder::takeChange(bool whole) {
    EventLog& log = timeline_.log();
    const std::size_t unchanged = log.takeUnchanged();
    SessionChange change{whole ? 0 : unchanged, {}, stepsAsSaved()};
    for (std::size_t i = change.from; i < log.entries().size(); ++i) {
        change.events.push_back(eventAsSaved(log.entries()[i], timeline_.hasChanged()));
        if (std::optional<SessionEvent>& event = change.events.back()) {
            event->action = countedFrom(event->action, -body_.document.session.origin);
        }
    }
    return change;
}

int SceneRecorder::stepsAsSaved() const {
    const SessionPlayback* const playback = timeline_.playback();
    if (isUntouched() && (playback == nullptr || playback->isPast())) {
        return std::max(body_.document.session.steps, timeline_.log().lastStep());
    }
    return playback != nullptr ? playback->steps() : std::max(1, body_.simulation.stepCount());
}

/// Whether a session that is saved now ends with what a person did last.
bool SceneRecorder::endsNow() const {
    const int step = body_.simulation.stepCount();
    if (const SessionPlayback* const playback = timeline_.playback()) {
        return timeline_.goesOn() && step > body_.document.session.steps &&
               step == playback->steps();
    }
    return step > 0 && !isUntouched();
}

/// The pictures of a session that was opened depend on its view.
void SceneRecorder::setView(Session& session, const render::Camera& camera,
                            const render::ChosenColors& colors) const {
    const bool keepsView = !body_.document.session.events.empty() || isUntouched();
    if (chosenView_) {
        session.view = chosenView_;
    } else if (!keepsView) {
        session.view = camera;
    } else if (!session.view && colors.any()) {
        session.view = body_.document.camera;  // the one that it has of itself
    }
    session.colors = colors;
}

LogPosition SceneRecorder::here() const {
    return timeline_.log().here(body_.simulation.stepCount());
}

LogPosition SceneRecorder::end() const {
    const auto& entries = timeline_.log().entries();
    return {stepsAsSaved(), entries.empty() ? 0 : entries.back().id};
}

bool SceneRecorder::takesPictures() const {
    return std::ranges::any_of(timeline_.log().entries(), [](const LogEntry& entry) {
        return std::holds_alternative<ScreenshotEvent>(entry.event.action);
    });
}

std::string SceneRecorder::addPicture(const LogPosition& place) {
    std::string file = freeOutputName(timeline_.log(), body_.document.name, place.step, ".png");
    addMark(place, ScreenshotEvent{file});
    return file;
}

std::string SceneRecorder::addExport() {
    const LogPosition place = here();
    std::string file = freeOutputName(timeline_.log(), body_.document.name, place.step, ".ply");
    addMark(place, ExportEvent{file, false, Coordinates::model});
    return file;
}

void SceneRecorder::addCheck() {
    addMark(here(), checkOfNow());
}

void SceneRecorder::addCamera(const render::Camera& camera) {
    addMark(here(), CameraEvent{camera});
}

void SceneRecorder::addName(const std::string& name) {
    addMark(here(), MarkEvent{name});
}

void SceneRecorder::addMark(const LogPosition& place, SessionAction action) {
    timeline_.log().add(place, std::move(action));
    timeline_.extendTo(place.step);
}

}  // namespace kerf::app
