#include "app/editor/storage/file_work.h"

#include <utility>

#include "app/editor/storage/manual.h"
#include "app/files/io/free_file.h"

namespace kerf::app {
namespace {

constexpr double kQuietSeconds = 0.3;  // nothing is said of work that is over sooner

}  // namespace

FileWork::~FileWork() {
    if (saving_.now() != nullptr) {
        saving_.now()->wait();
    }
    behind_.finish();
}

void FileWork::open(OpeningOrder order, const Mending& mending) {
    opening_.start(std::make_unique<DocumentLoading>(std::move(order), mending));
}

std::optional<UploadedDocument> FileWork::advanceOpening(bool mayTake) {
    std::unique_ptr<DocumentLoading> opening = opening_.take();
    opening->advance();
    if (opening->ready() && mayTake) {
        return opening->take();
    }
    opening_.start(std::move(opening));
    return std::nullopt;
}

std::unique_ptr<BodyPlacing> FileWork::takePlacing() {
    return placing() != nullptr && placing()->done() ? placing_.take() : nullptr;
}

int FileWork::saveBehind(const std::string& name, const std::string& ending,
                         std::function<void(const std::filesystem::path& file)> write) {
    return behind_.add([folder = folder_, name, ending, write = std::move(write)] {
        const std::filesystem::path file = freeFile(folder, name, ending);
        write(file);
        return "Saved " + file.string();
    });
}

void FileWork::openManual() {
    behind_.add([] { return openOutside(manualPage()); });
}

std::optional<SavingQueue::Outcome> FileWork::takeOutcome() {
    opening_.forgetEnded();
    placing_.forgetEnded();
    saving_.forgetEnded();
    const bool ended = saving() != nullptr && saving()->done();
    return ended ? SavingQueue::endOf(*saving_.take(), 0) : behind_.takeOutcome();
}

ui::WorkState FileWork::state() const {
    ui::WorkState work;
    if (const DocumentLoading* const loading = opening()) {
        work = {loading->order().title, loading->stage()};
        work.seconds = loading->seconds();
    } else if (const BodyPlacing* const placed = placing()) {
        work = {"Placing model", placed->stage()};
        work.seconds = placed->seconds();
    } else if (const FileSaving* const file = saving()) {
        work = {file->title, file->stage(), double(file->progress().done()),
                double(file->progress().all())};
        work.seconds = file->seconds();
    }
    return work.seconds < kQuietSeconds ? ui::WorkState{} : work;
}

}  // namespace kerf::app
