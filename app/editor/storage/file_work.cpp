#include "app/editor/storage/file_work.h"

#include <sys/wait.h>

#include <cstdlib>
#include <regex>

#include "app/editor/storage/file_chooser.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "gpu/data_path.h"

namespace kerf::app {

namespace {

constexpr double kQuietSeconds = 0.3;  // nothing is said of work that is over sooner

}  // namespace

void ModelWatch::begin(const std::vector<std::filesystem::path>& files) {
    const std::vector<Watched> before = std::exchange(files_, {});
    changed_.clear();
    for (const std::filesystem::path& file : files) {
        if (std::ranges::find(files_, file, &Watched::file) != files_.end()) {
            continue;
        }
        const auto known = std::ranges::find(before, file, &Watched::file);
        files_.push_back(known != before.end() ? *known : Watched{file, stampOf(file), {}});
    }
}

bool ModelWatch::look() {
    const std::size_t before = changed_.size();
    for (Watched& watched : files_) {
        const std::optional<FileStamp> now = stampOf(watched.file);
        const bool rests = now == std::exchange(watched.seen, now);
        if (now && rests && now != std::exchange(watched.known, now) &&
            std::ranges::find(changed_, watched.file) == changed_.end()) {
            changed_.push_back(watched.file);
        }
    }
    return changed_.size() > before;
}

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

std::unique_ptr<RepairSearch> FileWork::takeSearch() {
    return search() != nullptr && search()->done() ? search_.take() : nullptr;
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
    search_.forgetEnded();
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
    } else if (const RepairSearch* const repair = search()) {
        work = {"Looking for a repair", repair->stage()};
        work.seconds = repair->seconds();
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

std::filesystem::path manualPage() {
    const std::filesystem::path installed =
        gpu::programFolder().parent_path() / "share/doc/kerf/html/index.html";
    for (const std::filesystem::path& page : {installed, gpu::dataPath("out/docs/index.html")}) {
        if (std::filesystem::exists(page)) {
            return page;
        }
    }
    return gpu::dataPath("docs/index.md");
}

std::string openOutside(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) {
        throw OutputError("The manual is not installed: there is no " + file.string() + ".");
    }
    // It may become the browser and not end, which is no failure.
    const std::string quoted =
        "'" + std::regex_replace(file.string(), std::regex("'"), "'\\''") + "'";
    const int status =
        std::system(("command -v xdg-open >/dev/null || exit 127; xdg-open " + quoted +
                     " >/dev/null 2>&1 & for i in 1 2 3 4 5 6; do sleep 0.5; "
                     "kill -0 $! 2>/dev/null || { wait $!; exit; }; done")
                        .c_str());
    if (status != 0) {
        const bool missing = WIFEXITED(status) && WEXITSTATUS(status) == 127;
        throw OutputError("The manual is " + file.string() + ", but " +
                          (missing ? "xdg-open, which would show it, is not installed."
                                   : "no program was found to show it."));
    }
    return "Opened " + file.string();
}

void SessionFile::begin(const std::filesystem::path& file) {
    path_ = isOurs(file) ? std::filesystem::path() : file;
    stamp_ = stampOf(path_);
}

void SessionFile::noteWritten(const std::filesystem::path& file) {
    path_ = file;
    stamp_ = stampOf(file);
}

std::string SessionFile::doubt() const {
    const std::optional<FileStamp> now = stampOf(path_);
    return !now || now == stamp_
               ? ""
               : path_.filename().string() +
                     " was changed by another program. Saving replaces that version.";
}

}  // namespace kerf::app
