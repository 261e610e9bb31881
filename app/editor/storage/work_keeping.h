#pragma once

#include <deque>

#include "app/files/jobs/background_job.h"
#include "app/journal/journal_folder.h"
#include "app/journal/journal_writer.h"
#include "app/scene/document/document_loading.h"
#include "app/scene/editor_scene.h"
#include "render/scene/image.h"
#include "sim/base/stopwatch.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// Autosave: writes what is done to the open scene to disk at once, in a journal that a later start
/// can recover, with a small picture. It also knows what is unsaved.
class WorkKeeping {
  public:
    /// Journals are in `folder`; an empty path keeps none.
    explicit WorkKeeping(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Begins with another scene and drops the journal of the previous one. `left`: recovered work,
    /// which is kept until the new journal has it; may be null.
    void begin(std::shared_ptr<LeftJournal> left = nullptr);
    /// Drops the scene and its journal.
    void discard();
    /// Drops the scene and keeps its journal, as work left behind. Waits until it is on the disk.
    /// Returns whether there is any.
    bool leave();

    /// Once a frame, between two steps: records what has been done since. Without `on`, nothing is
    /// kept.
    void follow(EditorScene& scene, const render::Camera& camera,
                const render::ChosenColors& colors, bool on, double elapsedSeconds);
    /// Time until a picture of the scene is due [s]; none if none is.
    std::optional<double> pictureDue() const;
    /// Takes that picture.
    void keepPicture(render::Image picture);
    /// A sentence about what could not be written, once.
    std::optional<std::string> takeProblem();

    /// Records that a file has all up to EditorScene::deeds().
    void noteSaved(int deeds) { savedDeeds_ = deeds; }
    int savedDeeds() const { return savedDeeds_; }
    /// Whether there is unsaved work.
    bool isUnsaved(int deeds) const { return deeds != savedDeeds_; }
    /// Whether nothing is being written, and follow() has nothing to do.
    bool settled() const;

  private:
    void start(EditorScene& scene, Session session);
    void note(EditorScene& scene);
    void write(SessionChange change, bool unsaved);
    void giveUpWriter();

    std::filesystem::path folder_;
    std::unique_ptr<JournalWriter> writer_;              ///< null before there is anything to write
    std::vector<std::unique_ptr<JournalWriter>> ended_;  ///< that are being removed
    std::shared_ptr<LeftJournal> left_;                  ///< see begin()
    std::shared_ptr<ModelHashes> hashes_;                ///< of the writer's thread
    Session session_;                                    ///< without events, with the present view
    int savedDeeds_ = 0;
    bool unsaved_ = false;                ///< as last written
    int steps_ = 0;                       ///< the same
    Stopwatch sinceLine_;                 ///< the last one
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
