#pragma once

#include <optional>
#include <string>

#include "app/scene/timeline/saved_session.h"
#include "app/scene/timeline/scene_timeline.h"
#include "app/session/session_change.h"
#include "render/scene/body_look.h"

namespace kerf::app {

/// What was done to a scene, as a session: recorded, kept, saved, with its pictures, exports and
/// checks.
class SceneRecorder {
  public:
    /// Both must outlive it.
    SceneRecorder(SceneBody& body, SceneTimeline& timeline) : body_(body), timeline_(timeline) {}

    /// Adds a check of the state now and then from now on, of a scene that was begun anew.
    void start() { recording_ = recorded_ = true; }
    void stop() { recording_ = false; }
    bool recording() const { return recording_; }
    /// Adds that check, where one is due.
    void checkNowAndThen();

    /// Writes down all that was done since the start, as a session that ends here with a check of
    /// the state. A session that is played is written whole, with what a person added, wherever it
    /// stands; it keeps its view. Other documents get `camera`, unless useView() gave one to them.
    SavedSession savedSession(const render::Camera& camera, const render::ChosenColors& colors,
                              SavedAs purpose = SavedAs::session);
    /// What has become since the last call of the events that savedSession() would have, but for
    /// its last check; all of them where `whole`.
    SessionChange takeChange(bool whole);
    /// That session without events.
    Session sessionWithoutEvents(const render::Camera& camera,
                                 const render::ChosenColors& colors) const;
    /// Grows with all that a person does that a saved session would have.
    int deeds() const { return timeline_.journal().deeds() + (body_.document.inFile ? 0 : 1); }
    /// The view for the pictures of the session.
    void useView(const render::Camera& camera) { chosenView_ = camera; }

    /// The present in the session, to add a picture of it later on.
    JournalPlace here() const;
    /// The last place in the session as it would be saved now.
    JournalPlace end() const;
    /// Whether a replay of the session would take any.
    bool takesPictures() const;
    /// Adds a picture under a name of its own, which it returns.
    std::string addPicture(const JournalPlace& place);
    /// Adds an export of the body as it is under a name of its own, which it returns.
    std::string addExport();
    /// Adds a check of the state as it is.
    void addCheck();
    /// From there a film of the session shall be seen at this step.
    void addCamera(const render::Camera& camera);
    /// Takes out one of those by its ui::SessionMark::id.
    void removeMark(int id) { timeline_.journal().remove(id); }

  private:
    bool isUntouched() const;
    int stepsAsSaved() const;
    bool endsNow() const;
    CheckEvent checkOfNow();
    void setView(Session& session, const render::Camera& camera,
                 const render::ChosenColors& colors) const;
    void addMark(const JournalPlace& place, SessionAction action);

    SceneBody& body_;
    SceneTimeline& timeline_;
    std::optional<render::Camera> chosenView_;
    bool recording_ = false;
    bool recorded_ = false;  ///< the document was begun anew by a recording
};

}  // namespace kerf::app
