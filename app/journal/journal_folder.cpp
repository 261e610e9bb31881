#include "app/journal/journal_folder.h"

#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>

#include <chrono>

#include "app/files/io/file_io.h"
#include "app/journal/journal_writer.h"
#include "gpu/data_path.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::hours kHour(1);
constexpr int kMostPictureSide = 1024;  // [px]

/// The time since it was written last; none at all where it is gone.
fs::file_time_type::duration ageOf(const fs::path& file) {
    std::error_code error;
    const fs::file_time_type written = fs::last_write_time(file, error);
    return error ? fs::file_time_type::duration{} : fs::file_time_type::clock::now() - written;
}

std::time_t timeOf(const fs::path& file) {
    struct stat status {};
    return ::stat(file.c_str(), &status) == 0 ? status.st_mtime : 0;
}

/// Their names begin with the time: the last first.
std::vector<fs::path> filesIn(const fs::path& folder, const std::string& ending) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() == ending) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files, std::greater<>());
    return files;
}

std::shared_ptr<const render::Image> pictureBeside(const fs::path& journal) {
    try {
        render::Image picture = readPicture(pictureOf(journal));
        const bool isOurs = std::max(picture.width, picture.height) <= kMostPictureSide;
        return isOurs ? std::make_shared<const render::Image>(std::move(picture)) : nullptr;
    } catch (const std::exception&) {  // there is none yet
        return nullptr;
    }
}

/// None where it can't be read, or nothing is lost with it.
std::optional<LeftWork> workIn(const std::shared_ptr<LeftJournal>& journal) {
    try {
        LeftWork left{journal, readJournal(journal->file()), timeOf(journal->file()),
                      pictureBeside(journal->file())};
        if (left.kept.unsaved) {
            return left;
        }
        journal->remove();
    } catch (const InputError& error) {
        spdlog::warn("{}", error.what());
    }
    return std::nullopt;
}

/// Halves of files that never got their names, and pictures whose journals are gone.
void tidyUp(const fs::path& folder) {
    std::error_code error;
    for (const fs::path& part : filesIn(folder, ".part")) {
        if (ageOf(part) > kHour && LeftJournal(part).isOurs()) {
            fs::remove(part, error);
        }
    }
    for (const fs::path& picture : filesIn(folder, ".png")) {
        if (!fs::exists(fs::path(picture).replace_extension(".journal"), error)) {
            fs::remove(picture, error);
        }
    }
}

}  // namespace

LeftJournal::LeftJournal(fs::path file)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(), O_RDONLY | O_CLOEXEC)),
      ours_(descriptor_.get() >= 0 && SystemFile::lockFile(descriptor_.get())) {
    // Another window may have taken it away between the two.
    std::error_code error;
    ours_ = ours_ && fs::exists(file_, error);
}

void LeftJournal::remove() {
    removeJournal(file_);
    descriptor_.close();
    ours_ = false;
}

std::vector<LeftWork> lookForLeftWork(const fs::path& folder) {
    std::vector<LeftWork> works;
    std::size_t left = 0;
    for (const fs::path& file : filesIn(folder, ".journal")) {
        const auto journal = std::make_shared<LeftJournal>(file);
        if (!journal->isOurs()) {
            continue;
        }
        if (left >= kMostLeftJournals || ageOf(file) > kDaysOfJournals * 24 * kHour) {
            journal->remove();
        } else if (auto work = workIn(journal)) {
            works.push_back(std::move(*work));
            ++left;
        }
    }
    tidyUp(folder);
    return works;
}

fs::path defaultJournalFolder() {
    return gpu::statePath("journal");
}

}  // namespace kerf::app
