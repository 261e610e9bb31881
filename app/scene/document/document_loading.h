#pragma once

#include "app/files/import/model_source.h"
#include "app/files/jobs/background_job.h"
#include "app/scene/document/editor_document.h"
#include "render/scene/depth_field.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

/// A document with all expensive parts that need no OpenGL.
struct PreparedDocument {
    Document document;
    PreparedBody body;
    render::DepthField depth;  ///< below the skin of the body at rest
};

/// On any thread. Throws WorkCancelled if `progress` was cancelled, and MemoryShortage, before
/// anything is prepared, where `means` don't do for the document.
PreparedDocument prepareDocument(Document document, WorkProgress* progress = nullptr,
                                 const std::optional<MemoryMeans>& means = std::nullopt);

/// A document whose body is being uploaded, or was.
struct UploadedDocument {
    explicit UploadedDocument(PreparedDocument prepared);

    Document document;
    BodyUpload body;
    render::DepthField depth;
};

/// A request to open something.
struct OpeningOrder {
    std::string title;           ///< "Opening bunny.ply"
    std::filesystem::path file;  ///< to be read; empty for none
    /// Reads it, on any thread.
    std::function<Document(const ReadOptions& options)> open;
    std::function<void()> shown = nullptr;  ///< called once it is open; may be null
    /// Its name as a change of the open scene, such as "Remesh", which is kept for undo. Empty: it
    /// is another document.
    std::string change = {};
    bool atEnd = false;  ///< a session is shown at its end, see EditorScene::goToEnd()
    /// Called with it, on this thread, before it is shown; may be null.
    std::function<void(Document&)> complete = nullptr;
    std::string remark = {};  ///< told once it is open, before what is told of the document
};
/// The editor's options for reading models: with their faults, if the search is short.
ReadOptions editorReading(const MemoryMeans& means);
/// The order to open a model, or a session at its end.
OpeningOrder orderOf(const std::filesystem::path& file, const StoredEnds& ends);

/// What to open of files and folders that were dropped together.
struct DroppedFiles {
    /// A file of any kind, or several models for one scene; what only goes with them is left out.
    std::vector<std::filesystem::path> files;
    std::string remark;  ///< what was left out, for people; may be empty
};
/// Takes a session before all else; then models, with those of dropped folders in the order of
/// their names, as many as a scene can hold; else the first file.
DroppedFiles sortDropped(const std::vector<std::filesystem::path>& dropped);
/// The order to open several models in one scene.
OpeningOrder orderOf(const std::vector<std::filesystem::path>& models);

/// Finds out, on a separate thread, which repair would help a model that can't be cut.
class RepairSearch {
  public:
    explicit RepairSearch(OpeningOrder order);

    const OpeningOrder& order() const { return order_; }
    /// The fault with its help, once it is done, only once. Throws InputError.
    ModelFault take() { return job_.take(); }
    bool done() const { return job_.done(); }
    std::string stage() const { return job_.stage(); }
    double seconds() const { return job_.seconds(); }
    void cancel() { job_.cancel(); }

  private:
    OpeningOrder order_;
    BackgroundJob<ModelFault> job_;
};

/// Loads a document into the editor: reads and prepares it on a separate thread, then uploads it a
/// portion each frame. The open scene continues meanwhile.
class DocumentLoading {
  public:
    explicit DocumentLoading(OpeningOrder order, const Mending& mending = {});

    /// Call it once a frame, on the thread of the context. Throws InputError if the file can't be
    /// opened, gpu::ShaderError, gpu::OutOfMemory.
    void advance();
    /// take() may be called.
    bool ready() const { return uploaded_ != nullptr && uploaded_->body.done(); }
    UploadedDocument take() { return std::move(*uploaded_); }
    /// Whether the thread works; meanwhile frames may be rare.
    bool preparing() const { return uploaded_ == nullptr; }

    const OpeningOrder& order() const { return order_; }
    const Mending& mending() const { return mending_; }
    std::string stage() const { return job_.stage(); }
    double seconds() const { return job_.seconds(); }
    /// Makes the thread end soon; its result is lost.
    void cancel() { job_.cancel(); }
    /// Whether the thread has ended, so that nobody has to wait for it.
    bool done() const { return job_.done(); }

  private:
    OpeningOrder order_;
    Mending mending_;
    BackgroundJob<PreparedDocument> job_;
    std::unique_ptr<UploadedDocument> uploaded_;
};

}  // namespace kerf::app
