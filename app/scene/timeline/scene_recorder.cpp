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
        timeline_.journal().note(step, checkOfNow());
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
    SavedSession saved = sessionAsSaved(body_.document.session, timeline_.journal(), purpose);
    Session& session = saved.session;
    session.steps = stepsAsSaved();
    if (purpose == SavedAs::session && endsNow()) {
        session.events.push_back({session.steps, checkOfNow()});
    }
    setView(session, camera, colors);
    return saved;
}

std::optional<SavedEnd> SceneRecorder::savedEnd() {
    Simulation& now = body_.simulation;
    if (now.stepCount() != stepsAsSaved() || now.blade()) {
        return std::nullopt;
    }
    return SavedEnd{now.moment(), now.stateHash(), timeline_.start()};
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
    SessionJournal& journal = timeline_.journal();
    const std::size_t unchanged = journal.takeUnchanged();
    SessionChange change{whole ? 0 : unchanged, {}, stepsAsSaved()};
    for (std::size_t i = change.from; i < journal.entries().size(); ++i) {
        change.events.push_back(eventAsSaved(journal.entries()[i], timeline_.hasChanged()));
        if (std::optional<SessionEvent>& event = change.events.back()) {
            event->action = countedFrom(event->action, -body_.document.session.origin);
        }
    }
    return change;
}

int SceneRecorder::stepsAsSaved() const {
    const SessionPlayback* const playback = timeline_.playback();
    if (isUntouched() && (playback == nullptr || playback->isPast())) {
        return std::max(body_.document.session.steps, timeline_.journal().lastStep());
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

JournalPosition SceneRecorder::here() const {
    return timeline_.journal().here(body_.simulation.stepCount());
}

JournalPosition SceneRecorder::end() const {
    const auto& entries = timeline_.journal().entries();
    return {stepsAsSaved(), entries.empty() ? 0 : entries.back().id};
}

bool SceneRecorder::takesPictures() const {
    return std::ranges::any_of(timeline_.journal().entries(), [](const JournalEntry& entry) {
        return std::holds_alternative<ScreenshotEvent>(entry.event.action);
    });
}

std::string SceneRecorder::addPicture(const JournalPosition& place) {
    std::string file = freeOutputName(timeline_.journal(), body_.document.name, place.step, ".png");
    addMark(place, ScreenshotEvent{file});
    return file;
}

std::string SceneRecorder::addExport() {
    const JournalPosition place = here();
    std::string file = freeOutputName(timeline_.journal(), body_.document.name, place.step, ".ply");
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

void SceneRecorder::addMark(const JournalPosition& place, SessionAction action) {
    timeline_.journal().add(place, std::move(action));
    timeline_.extendTo(place.step);
}

}  // namespace kerf::app
