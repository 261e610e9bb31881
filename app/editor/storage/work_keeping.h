#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/journal/journal_folder.h"
#include "app/journal/journal_writer.h"
#include "app/scene/editor_scene.h"
#include "render/scene/image.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {

/// Keeps what is done to the open scene on the disk at once, in a journal that another start of the
/// editor can go on from, with a small picture beside it. It knows, too, what of it no file has.
class WorkKeeping {
  public:
    /// Journals lie in `folder`; an empty path keeps none.
    explicit WorkKeeping(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Another scene is open from now on; the journal of the one before is not needed any more.
    /// `left`: what it goes on from, which stays until the new journal has it; may be null.
    void begin(std::shared_ptr<LeftJournal> left = nullptr);
    /// The scene is given up, and what is kept of it.
    void discard();
    /// The scene is gone, and what is kept of it stays, as work that was left behind. Waits until
    /// it is on the disk. Returns whether there is any.
    bool leave();

    /// Once a picture, between two steps: notes what has been done since. Without `on`, nothing is
    /// kept.
    void follow(EditorScene& scene, const render::Camera& camera,
                const render::ChosenColors& colors, bool on, double elapsedSeconds);
    /// Time until a picture of the scene is wanted [s]; none while none is.
    std::optional<double> pictureDue() const;
    /// Takes that picture.
    void keepPicture(render::Image picture);
    /// A sentence about what could not be kept, once.
    std::optional<std::string> takeProblem();

    /// A file has what was done, up to EditorScene::deeds().
    void noteSaved(int deeds) { savedDeeds_ = deeds; }
    int savedDeeds() const { return savedDeeds_; }
    /// Whether a person has done something that no file has.
    bool isUnsaved(int deeds) const { return deeds != savedDeeds_; }
    /// Whether nothing is on its way to the disk, and follow() has nothing to do of itself.
    bool settled() const;

  private:
    void start(EditorScene& scene, Session session);
    void note(EditorScene& scene);
    void write(SessionChange change, bool unsaved);
    void giveUpWriter();

    std::filesystem::path folder_;
    std::unique_ptr<JournalWriter> writer_;              ///< null before there is anything to keep
    std::vector<std::unique_ptr<JournalWriter>> ended_;  ///< that are being taken away
    std::shared_ptr<LeftJournal> left_;                  ///< see begin()
    std::shared_ptr<ModelHashes> hashes_;                ///< of the writer's thread
    Session session_;                                    ///< without events, with the view of now
    int savedDeeds_ = 0;
    bool unsaved_ = false;                ///< as it was written last
    int steps_ = 0;                       ///< the same
    Stopwatch sinceLine_;                 ///< the last one
    std::optional<double> untilPicture_;  ///< [s]
};

}  // namespace kerf::app
