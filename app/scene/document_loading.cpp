#include "app/scene/document_loading.h"

#include <utility>

namespace kerf::app {
namespace {

constexpr double kUploadBudget = 0.006;  // of a picture [s]; a portion may take longer

}  // namespace

PreparedDocument prepareDocument(Document document, WorkProgress* progress) {
    PreparedBody body(
        document.mesh, [&](const char* stage) { enter(progress, stage); }, document.placed);
    enter(progress, "Measuring the depth below the skin");
    render::DepthField depth = render::measureSkinDepth(document.mesh);
    enter(progress, "Bringing it to the GPU");
    return {std::move(document), std::move(body), std::move(depth)};
}

UploadedDocument::UploadedDocument(PreparedDocument prepared)
    : document(std::move(prepared.document)),
      body(std::move(prepared.body)),
      depth(std::move(prepared.depth)) {}

OpeningOrder orderOf(const std::filesystem::path& file) {
    return {"Opening " + file.filename().string(), file,
            [file](const ReadOptions& options) { return openDocument(file, options); }};
}

DocumentLoading::DocumentLoading(OpeningOrder order, bool fillHoles)
    : order_(std::move(order)), job_([open = order_.open, fillHoles](WorkProgress& progress) {
          ReadOptions options;
          options.fillHoles = fillHoles;
          options.tryFilling = !fillHoles;
          options.progress = &progress;
          return prepareDocument(open(options), &progress);
      }) {}

void DocumentLoading::advance() {
    if (uploaded_ == nullptr && job_.done()) {
        uploaded_ = std::make_unique<UploadedDocument>(job_.take());
        return;  // The kernels were compiled: enough for one picture.
    }
    const Stopwatch watch;
    while (uploaded_ != nullptr && !uploaded_->body.done()) {
        uploaded_->body.advance();
        if (watch.seconds() > kUploadBudget) {
            return;
        }
    }
}

}  // namespace kerf::app
