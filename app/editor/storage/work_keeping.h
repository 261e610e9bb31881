#pragma once

#include <deque>

#include "app/files/jobs/background_job.h"
#include "app/journal/journal.h"
#include "app/scene/document/document_loading.h"
#include "app/scene/editor_scene.h"
#include "render/scene/image.h"
#include "sim/base/stopwatch.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// Autosave: keeps the list of what is done to the open scene on the disk, from which a later start
/// can recover it, with a small picture. It also knows what is unsaved.
class WorkKeeping {
  public:
    /// Journals are in `folder`; an empty path keeps none.
    explicit WorkKeeping(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Begins with another scene, in place of the previous one. `left`: the journal of recovered
    /// work, which goes on; null for none.
    void begin(std::shared_ptr<Journal> left = nullptr);
    /// Drops the scene and its journal.
    void discard();
    /// Drops the scene and keeps its journal, as work left behind. Returns whether there is any.
    bool leave();

    /// Once a frame, between two steps: records what has been done since. Without `on`, nothing is
    /// kept.
    void follow(EditorScene& scene, const SavedView& seen, const render::ChosenColors& colors,
                bool on, double elapsedSeconds);
    /// Time until a picture of the scene is due [s]; none if none is.
    std::optional<double> pictureDue() const { return untilPicture_; }
    /// Takes that picture.
    void keepPicture(const render::Image& picture);
    /// A sentence about what could not be written, once.
    std::optional<std::string> takeProblem();

    /// Records that a file has all up to EditorScene::deeds(). Where keeping had stopped, it begins
    /// anew.
    void noteSaved(int deeds);
    int savedDeeds() const { return savedDeeds_; }
    /// Whether there is unsaved work.
    bool isUnsaved(int deeds) const { return deeds != savedDeeds_; }

  private:
    void start(EditorScene& scene);
    void note(EditorScene& scene);
    bool isDue(EditorScene& scene) const;

    std::filesystem::path folder_;
    std::shared_ptr<Journal> journal_;  ///< null before there is anything to keep
    bool begun_ = false;                ///< it has the open scene
    Session session_;                   ///< without events, with the present view
    int savedDeeds_ = 0;
    bool unsaved_ = false;                ///< as last written
    int steps_ = 0;                       ///< the same
    Stopwatch sinceWrite_;                ///< the last one
    double lastWrite_ = 0;                ///< how long that took [s]
    std::optional<double> untilPicture_;  ///< [s]
};

/// The work of windows that ended without being closed: searched once on a separate thread, and
/// offered one after the other.
class LeftWorkOffers {
  public:
    bool comingBack = false;  ///< recovered work is still being played, see Editor::State

    /// Begins to search `folder`; an empty path has nothing.
    explicit LeftWorkOffers(const std::filesystem::path& folder);

    /// Searches again, for newer work.
    void lookAgain();
    /// Whether the thread is still searching.
    bool looking() const { return looking_ != nullptr; }
    /// Takes what the thread has found, once done; call it once a frame.
    void collect();
    /// The next work to offer, each once; the newest first.
    std::optional<LeftWork> next();
    /// Postpones the others to the next start.
    void putOff() { works_.clear(); }

  private:
    using Looking = BackgroundJob<std::vector<LeftWork>>;

    std::filesystem::path folder_;
    std::unique_ptr<Looking> looking_;
    std::deque<LeftWork> works_;
};

/// The choices of questionAbout().
enum LeftWorkChoice { kGoOn, kDiscard, kNotNow };
/// Asks what to do with such work.
ui::Question questionAbout(const LeftWork& work);
/// The order to recover it. A failure says where it is kept.
OpeningOrder orderOf(const LeftWork& work);

}  // namespace kerf::app
