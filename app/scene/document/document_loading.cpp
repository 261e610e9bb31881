#include "app/scene/document/document_loading.h"

namespace kerf::app {
namespace {

constexpr double kUploadBudget = 0.006;  // of a picture [s]; a portion may take longer
// Of a model of a million triangles the search would take four seconds.
constexpr std::size_t kMostSearched = 300'000;

/// While it is prepared, other documents may still be open.
MemoryMeans meansNow() {
    MemoryMeans means = memoryMeansOfContext();
    means.programRuns = true;
    return means;
}

}  // namespace

PreparedDocument prepareDocument(Document document, WorkProgress* progress,
                                 const std::optional<MemoryMeans>& means) {
    if (means) {
        requireMemory(document.name, memoryNeedOf(document), *means);
    }
    PreparedBody body(
        document.mesh, [&](const char* stage) { enter(progress, stage); }, document.placed);
    enter(progress, "Computing depth below the skin");
    render::DepthField depth = render::measureSkinDepth(document.mesh);
    enter(progress, "Uploading to GPU");
    return {std::move(document), std::move(body), std::move(depth)};
}

UploadedDocument::UploadedDocument(PreparedDocument prepared)
    : document(std::move(prepared.document)),
      body(std::move(prepared.body)),
      depth(std::move(prepared.depth)) {}

ReadOptions editorReading(const MemoryMeans& means) {
    ReadOptions options;
    options.means = means;
    options.findFaults = true;
    options.findCrossingsUpTo = kMostSearched;
    return options;
}

OpeningOrder orderOf(const std::filesystem::path& file, const StoredEnds& ends) {
    OpeningOrder order{"Opening " + file.filename().string(), file,
                       [file, ends](const ReadOptions& options) {
                           Document document = openDocument(file, options);
                           document.end = ends.of(file);
                           return document;
                       }};
    order.atEnd = true;
    return order;
}

RepairSearch::RepairSearch(OpeningOrder order)
    : order_(std::move(order)),
      job_([open = order_.open, means = meansNow()](WorkProgress& progress) {
          ReadOptions options = editorReading(means);
          options.tryRepair = true;
          options.progress = &progress;
          try {
              open(options);
          } catch (const ModelFault& fault) {
              return fault;
          }
          throw InputError("The model has changed on disk, and can be cut now; open it again.");
      }) {}

DocumentLoading::DocumentLoading(OpeningOrder order, const Mending& mending)
    : order_(std::move(order)),
      mending_(mending),
      job_([open = order_.open, mending, means = meansNow()](WorkProgress& progress) {
          ReadOptions options = editorReading(means);
          options.add(mending);
          options.progress = &progress;
          return prepareDocument(open(options), &progress, means);
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
