#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/storage/file_saving.h"
#include "app/files/jobs/current_job.h"
#include "app/files/jobs/saving_queue.h"
#include "app/scene/document/body_placing.h"
#include "app/scene/document/document_loading.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// Files on their way in and out, while what is open goes on: one to be opened, one to be saved,
/// and behind them pictures and plots, for which nobody waits.
class FileWork {
  public:
    /// What comes once the file is there that is being saved; may be null.
    std::function<void()> onceSaved;
    /// What comes after the session is saved that the dialog asks a name for, or that is being
    /// saved; may be null.
    std::function<void()> afterSaving;

    /// Pictures and plots go into `folder`.
    explicit FileWork(std::filesystem::path folder) : folder_(std::move(folder)) {}
    /// Waits until what was to be saved is saved.
    ~FileWork();
    FileWork(const FileWork&) = delete;
    FileWork& operator=(const FileWork&) = delete;

    /// Begins to open something, instead of what was being opened before.
    void open(OpeningOrder order, const Mending& mending);
    /// What is being opened; null for none.
    const DocumentLoading* opening() const { return opening_.now(); }
    /// Goes on with that file, once a picture. Returns the document once it is ready and `mayTake`.
    /// Then, and where it throws as DocumentLoading::advance(), nothing is being opened any more.
    std::optional<UploadedDocument> advanceOpening(bool mayTake);

    /// Begins to place a model, instead of what was being placed before.
    void place(std::unique_ptr<BodyPlacing> placing) { placing_.start(std::move(placing)); }
    /// What is being placed; null for nothing.
    const BodyPlacing* placing() const { return placing_.now(); }
    /// The placement once it is ready; null before. Nothing is being placed any more then.
    std::unique_ptr<BodyPlacing> takePlacing();
    /// Gives up what is being placed.
    void stopPlacing() { placing_.cancel(); }

    /// Follows a saving that has begun; there is only one at a time.
    void save(std::unique_ptr<FileSaving> saving) { saving_.start(std::move(saving)); }
    /// The saving that is not done yet; null for none.
    const FileSaving* saving() const { return saving_.now(); }
    /// Lets `write` encode and write a new file NAME-YYYYMMDD-HHMMSS with that ending, behind those
    /// before it. Returns the number of its outcome.
    int saveBehind(const std::string& name, const std::string& ending,
                   std::function<void(const std::filesystem::path& file)> write);
    /// The end of a saving, each once; only those of saveBehind() have numbers.
    std::optional<SavingQueue::Outcome> takeOutcome();

    /// Gives up what is being opened, or else placed, or saved. Returns false where there is
    /// nothing.
    bool cancel() { return opening_.cancel() || placing_.cancel() || saving_.cancel(); }
    /// Whether anything is not saved yet.
    bool saves() const { return saving() != nullptr || behind_.busy(); }
    /// What a person may wait for, once it takes long.
    ui::WorkState state() const;

  private:
    std::filesystem::path folder_;
    CurrentJob<DocumentLoading> opening_;
    CurrentJob<BodyPlacing> placing_;
    CurrentJob<FileSaving> saving_;
    SavingQueue behind_;
};

}  // namespace kerf::app
