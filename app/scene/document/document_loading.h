#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/files/import/model_source.h"
#include "app/files/jobs/background_job.h"
#include "app/scene/document/editor_document.h"
#include "render/scene/depth_field.h"
#include "sim/run/start/body_upload.h"

namespace kerf::app {

/// A document with all that takes long and needs no OpenGL.
struct PreparedDocument {
    Document document;
    PreparedBody body;
    render::DepthField depth;  ///< below the skin of the body at rest
};

/// On any thread. Throws WorkCancelled where `progress` was cancelled, and MemoryShortage, before
/// anything is prepared, where `means` don't do for the document.
PreparedDocument prepareDocument(Document document, WorkProgress* progress = nullptr,
                                 const std::optional<MemoryMeans>& means = std::nullopt);

/// A document whose body is on its way to the GPU, or there.
struct UploadedDocument {
    explicit UploadedDocument(PreparedDocument prepared);

    Document document;
    BodyUpload body;
    render::DepthField depth;
};

/// What is to be shown instead of what is open.
struct OpeningOrder {
    std::string title;           ///< "Opening bunny.ply"
    std::filesystem::path file;  ///< that is read; empty where people know of none
    /// Reads it, on any thread.
    std::function<Document(const ReadOptions& options)> open;
    std::function<void()> shown = nullptr;  ///< called once it is what is open; may be null
    /// What it does to the scene that is open, "Remesh", as one change that is undone with it: that
    /// scene is kept. Empty: it is another document.
    std::string change = {};
};
/// How the editor reads models: with what is wrong with them, as far as the search is short.
ReadOptions editorReading(const MemoryMeans& means);
/// To open a model or a session.
OpeningOrder orderOf(const std::filesystem::path& file);

/// A document on its way into the editor: read and prepared on a thread of its own, then brought to
/// the GPU a portion a picture. What is open goes on meanwhile.
class DocumentLoading {
  public:
    explicit DocumentLoading(OpeningOrder order, const Mending& mending = {});

    /// Once a picture, on the thread of the context. Throws InputError where the file can't be
    /// opened, gpu::ShaderError, gpu::OutOfMemory.
    void advance();
    /// take() may be called.
    bool ready() const { return uploaded_ != nullptr && uploaded_->body.done(); }
    UploadedDocument take() { return std::move(*uploaded_); }
    /// The thread works; until then pictures need not follow each other closely.
    bool preparing() const { return uploaded_ == nullptr; }

    const OpeningOrder& order() const { return order_; }
    std::string stage() const { return job_.stage(); }
    double seconds() const { return job_.seconds(); }
    /// The thread ends soon; what it has made is lost.
    void cancel() { job_.cancel(); }
    /// The thread has ended, so that nobody has to wait for it.
    bool done() const { return job_.done(); }

  private:
    OpeningOrder order_;
    BackgroundJob<PreparedDocument> job_;
    std::unique_ptr<UploadedDocument> uploaded_;
};

}  // namespace kerf::app
