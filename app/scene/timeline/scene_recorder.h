#pragma once

#include "app/scene/timeline/saved_session.h"
#include "app/scene/timeline/scene_timeline.h"
#include "app/session/session.h"
#include "render/scene/body_look.h"

namespace kerf::app {

/// Records what was done to a scene, and saves it as a session, with its pictures, exports and
/// checks.
class SceneRecorder {
  public:
    /// Both must outlive it.
    SceneRecorder(SceneBody& body, SceneTimeline& timeline) : body_(body), timeline_(timeline) {}

    /// Adds a check of the state from time to time from now on, after a restart of the scene.
    void start() { recording_ = recorded_ = true; }
    void stop() { recording_ = false; }
    bool recording() const { return recording_; }
    /// Adds that check, if due.
    void checkNowAndThen();

    /// All that was done since the start, as a session that ends here with a check of the state. A
    /// played session is saved whole, with the user's additions, at any position; it keeps its
    /// view. Other documents get `camera`, unless useView() set one.
    SavedSession savedSession(const render::Camera& camera, const render::ChosenColors& colors,
                              SavedAs purpose = SavedAs::session);
    /// The state at the end of that session, if it is the present one, and no blade is placed.
    std::optional<SceneCheckpoint> savedEnd();
    /// The events of savedSession() that have changed since the last call, without its last check;
    /// all of them if `whole`.
    SessionChange takeChange(bool whole);
    /// That session without events.
    Session sessionWithoutEvents(const render::Camera& camera,
                                 const render::ChosenColors& colors) const;
    /// Grows with every user action that a saved session would have.
    int deeds() const { return timeline_.log().deeds() + (body_.document.inFile ? 0 : 1); }
    /// The view for the pictures of the session.
    void useView(const render::Camera& camera) { chosenView_ = camera; }

    /// The present in the session, to add a picture later.
    LogPosition here() const;
    /// The last place in the session as it would be saved now.
    LogPosition end() const;
    /// The steps of that session.
    int stepsAsSaved() const;
    /// Whether a replay of the session would take any.
    bool takesPictures() const;
    /// Adds a picture under a new name, which it returns.
    std::string addPicture(const LogPosition& place);
    /// Adds an export of the present body under a new name, which it returns.
    std::string addExport();
    /// Adds a check of the present state.
    void addCheck();
    /// Adds a camera key for films at this step.
    void addCamera(const render::Camera& camera);
    /// Names this step on the time line.
    void addName(const std::string& name);
    /// Removes one of these by its ui::SessionMark::id.
    void removeMark(int id) { timeline_.log().remove(id); }

  private:
    bool isUntouched() const;
    bool endsNow() const;
    CheckEvent checkOfNow();
    void setView(Session& session, const render::Camera& camera,
                 const render::ChosenColors& colors) const;
    void addMark(const LogPosition& place, SessionAction action);

    SceneBody& body_;
    SceneTimeline& timeline_;
    std::optional<render::Camera> chosenView_;
    bool recording_ = false;
    bool recorded_ = false;  ///< the document was begun anew by a recording
};

}  // namespace kerf::app
