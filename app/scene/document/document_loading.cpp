#include "app/scene/document/document_loading.h"

#include <spdlog/fmt/fmt.h>

#include "app/session/material.h"
#include "sim/base/size_params.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

constexpr double kUploadBudget = 0.006;  // of a picture [s]; a portion may take longer
// Of a model of a million triangles the search would take four seconds.
constexpr std::size_t kMostSearched = 300'000;

/// While it is prepared, other documents may still be open.
MemoryMeans meansNow() {
    MemoryMeans means = memoryMeansOfContext();
    means.programRuns = true;
    return means;
}

bool isSessionFile(const fs::path& file) {
    return lowerCase(file.extension().string()) == ".json" && !isMaterialFile(file);
}

/// By name.
std::vector<fs::path> modelsInside(const fs::path& folder) {
    std::vector<fs::path> models;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        if (isModelFile(entry.path()) && entry.is_regular_file(error)) {
            models.push_back(entry.path());
        }
    }
    std::ranges::sort(models);
    return models;
}

/// A model for whose implicit steps the driver's buffers are too small is solved by pbd, which
/// needs smaller ones. Sessions stay as they are, since they would have other bits.
void fitToBuffers(Document& document, const MemoryMeans& means) {
    const std::uint64_t wanted = memoryNeedOf(document).largestBuffer;
    if (!document.guess || wanted <= means.largestBuffer) {
        return;
    }
    Params& params = document.session.params;
    const Params implicit = params;
    params.solver = SolverMode::pbd;
    params = suitedTo(document.restBounds.diagonal(), params);
    if (memoryNeedOf(document).largestBuffer > means.largestBuffer) {
        params = implicit;
        return;
    }
    document.note += fmt::format(
        " Its implicit steps would need a buffer of {:.0f} MB, and this driver allows {:.0f} MB at "
        "most, so its solver is pbd, with smaller steps.",
        static_cast<double>(wanted) / 1e6, static_cast<double>(means.largestBuffer) / 1e6);
}

}  // namespace

PreparedDocument prepareDocument(Document document, WorkProgress* progress,
                                 const std::optional<MemoryMeans>& means) {
    if (means) {
        fitToBuffers(document, *means);
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

DroppedFiles sortDropped(const std::vector<fs::path>& dropped) {
    std::vector<fs::path> models;
    for (const fs::path& path : dropped) {
        std::error_code error;
        if (isSessionFile(path)) {
            return {{path}, dropped.size() == 1 ? "" : "Only the session was opened."};
        }
        if (fs::is_directory(path, error)) {
            const auto inside = modelsInside(path);
            models.insert(models.end(), inside.begin(), inside.end());
        } else if (isModelFile(path)) {
            models.push_back(path);
        }
    }
    if (models.empty()) {
        return {{dropped.front()}, ""};
    }
    const std::size_t all = models.size();
    models.resize(std::min<std::size_t>(all, kMostModels));
    return {models, all == models.size()
                        ? ""
                        : fmt::format("A scene can hold at most {} models: {} were left out.",
                                      kMostModels, all - models.size())};
}

OpeningOrder orderOf(const std::vector<fs::path>& models) {
    return {fmt::format("Opening {} models", models.size()), models.front(),
            [models](const ReadOptions& options) { return openModels(models, options); }};
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
