#pragma once

#include "app/editor/storage/file_saving.h"
#include "app/files/io/file_io.h"
#include "app/files/jobs/background_job.h"
#include "app/files/jobs/saving_queue.h"
#include "app/scene/document/body_placing.h"
#include "app/scene/document/document_loading.h"
#include "app/scene/document/stored_ends.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// Watches the model files of the open scene for changes by other programs. Each change is told
/// once.
class ModelWatch {
  public:
    /// Begins with the files of another scene. A file that is watched already may have changed
    /// while the scene was read, which the next look finds.
    void begin(const std::vector<std::filesystem::path>& files);
    /// Looks at the files. A change counts once a file is the same at two looks, since it may still
    /// be being written. Returns whether one counts now.
    bool look();
    /// The files whose change is offered.
    const std::vector<std::filesystem::path>& changed() const { return changed_; }
    /// Drops the offer.
    void ignore() { changed_.clear(); }

  private:
    struct Watched {
        std::filesystem::path file;
        std::optional<FileStamp> known;
        std::optional<FileStamp> seen;  ///< at the last look
    };
    std::vector<Watched> files_;
    std::vector<std::filesystem::path> changed_;
};

/// Background reading and writing of files: one being opened, one being saved, and a queue of
/// pictures and plots, for which nobody waits.
class FileWork {
  public:
    ModelWatch models;  ///< of the open scene
    /// Called once the file being saved exists; may be null.
    std::function<void()> onceSaved;
    /// Called if the file being saved can't be written; may be null.
    std::function<void()> ifNotSaved;
    /// Called once the session being named or saved is saved; may be null.
    std::function<void()> afterSaving;

    /// Pictures and plots go into `folder`.
    explicit FileWork(std::filesystem::path folder) : folder_(std::move(folder)) {}
    /// Waits until everything is saved.
    ~FileWork();
    FileWork(const FileWork&) = delete;
    FileWork& operator=(const FileWork&) = delete;

    /// Begins to open something, cancelling what was being opened before.
    void open(OpeningOrder order, const Mending& mending);
    /// What is being opened; null for none.
    const DocumentLoading* opening() const { return opening_.now(); }
    /// Continues with that file, once a frame. Returns the document once it is ready and `mayTake`.
    /// Then, and if it throws like DocumentLoading::advance(), nothing is being opened any more.
    std::optional<UploadedDocument> advanceOpening(bool mayTake);

    /// Begins to place a model, cancelling the previous placement.
    void place(std::unique_ptr<BodyPlacing> placing) { placing_.start(std::move(placing)); }
    /// What is being placed; null for nothing.
    const BodyPlacing* placing() const { return placing_.now(); }
    /// Takes the placement once it is ready; null before.
    std::unique_ptr<BodyPlacing> takePlacing();
    /// Cancels what is being placed.
    void stopPlacing() { placing_.cancel(); }

    /// Begins to look for a repair of a model, cancelling the previous search.
    void lookForRepair(OpeningOrder order) {
        search_.start(std::make_unique<RepairSearch>(std::move(order)));
    }
    /// The search for a repair; null for none.
    const RepairSearch* search() const { return search_.now(); }
    /// Takes the search once it is done; null before.
    std::unique_ptr<RepairSearch> takeSearch();
    void stopSearch() { search_.cancel(); }

    /// Takes a save in progress; only one at a time.
    void save(std::unique_ptr<FileSaving> saving) { saving_.start(std::move(saving)); }
    /// The save in progress; null for none.
    const FileSaving* saving() const { return saving_.now(); }
    /// Queues `write`, which encodes and writes a new file NAME-YYYYMMDD-HHMMSS with that ending.
    /// Returns the number of its outcome.
    int saveBehind(const std::string& name, const std::string& ending,
                   std::function<void(const std::filesystem::path& file)> write);
    /// Opens the documentation in the system's browser, in the background.
    void openManual();
    /// The end of a save, each once; only those of saveBehind() have numbers.
    std::optional<SavingQueue::Outcome> takeOutcome();

    /// Cancels what is being opened, or else looked for, placed, or saved. Returns false if there
    /// is nothing.
    bool cancel() {
        return opening_.cancel() || search_.cancel() || placing_.cancel() || saving_.cancel();
    }
    /// Whether anything is not saved yet.
    bool saves() const { return saving() != nullptr || behind_.busy(); }
    /// What the user may wait for, once it takes long.
    ui::WorkState state() const;

  private:
    std::filesystem::path folder_;
    CurrentJob<DocumentLoading> opening_;
    CurrentJob<RepairSearch> search_;
    CurrentJob<BodyPlacing> placing_;
    CurrentJob<FileSaving> saving_;
    SavingQueue behind_;
};

/// The first page of the documentation: the installed one, else that of the source tree.
std::filesystem::path manualPage();

/// Opens a file with the program that the desktop has for it, by xdg-open. Returns a sentence for
/// the user. Throws OutputError if that fails within a few seconds.
std::string openOutside(const std::filesystem::path& file);

/// The session file of the open scene, which saving writes again.
class SessionFile {
  public:
    const StoredEnds ends;  ///< of the sessions that were saved

    explicit SessionFile(StoredEnds stored) : ends(std::move(stored)) {}

    /// Begins with the file that was opened; empty for none, as for the sessions of Kerf's own.
    void begin(const std::filesystem::path& file);
    /// Records that this window has written the file.
    void noteWritten(const std::filesystem::path& file);
    const std::filesystem::path& path() const { return path_; }
    /// Why it should not be replaced without a question: one sentence, or "".
    std::string doubt() const;

  private:
    std::filesystem::path path_;
    std::optional<FileStamp> stamp_;  ///< when it was opened or written
};

}  // namespace kerf::app
