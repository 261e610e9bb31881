#include "app/editor/storage/model_watch.h"

#include <algorithm>
#include <utility>

namespace kerf::app {

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

}  // namespace kerf::app
