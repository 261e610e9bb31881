#include "app/scene/document_loading.h"

#include <utility>

namespace kerf::app {
namespace {

constexpr double kUploadBudget = 0.006;  // of a picture [s]; a portion may take longer

}  // namespace

PreparedDocument prepareDocument(Document document, WorkProgress* progress) {
    PreparedBody body(
        document.mesh, [&](const char* stage) { enter(progress, stage); },
        document.session.placement);
    enter(progress, "Measuring the depth below the skin");
    render::DepthField depth = render::measureSkinDepth(document.mesh);
    enter(progress, "Bringing it to the GPU");
    return {std::move(document), std::move(body), std::move(depth)};
}

UploadedDocument::UploadedDocument(PreparedDocument prepared)
    : document(std::move(prepared.document)),
      body(std::move(prepared.body)),
      depth(std::move(prepared.depth)) {}

DocumentLoading::DocumentLoading(std::filesystem::path file, bool fillHoles)
    : file_(std::move(file)), job_([path = file_, fillHoles](WorkProgress& progress) {
          ReadOptions options;
          options.fillHoles = fillHoles;
          options.tryFilling = !fillHoles;
          options.progress = &progress;
          return prepareDocument(openDocument(path, options), &progress);
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
