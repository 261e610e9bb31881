#include "app/editor/storage/left_work.h"

#include <spdlog/fmt/chrono.h>

#include <iterator>
#include <utility>

#include "sim/base/text.h"

namespace kerf::app {
LeftWorkOffers::LeftWorkOffers(const std::filesystem::path& folder) : folder_(folder) {
    lookAgain();
}

void LeftWorkOffers::lookAgain() {
    works_.clear();
    if (!folder_.empty()) {
        looking_ = std::make_unique<Looking>(
            [folder = folder_](WorkProgress&) { return lookForLeftWork(folder); });
    }
}

void LeftWorkOffers::collect() {
    if (looking_ != nullptr && looking_->done()) {
        std::ranges::move(looking_->take(), std::back_inserter(works_));
        looking_.reset();
    }
}

std::optional<LeftWork> LeftWorkOffers::next() {
    if (works_.empty()) {
        return std::nullopt;
    }
    LeftWork first = std::move(works_.front());
    works_.pop_front();
    return first;
}

ui::Question questionAbout(const LeftWork& work) {
    const std::string cuts =
        work.kept.cuts == 0 ? "changes but no cuts" : counted(work.kept.cuts, "cut", "cuts");
    return {"Recover unsaved work?",
            "Kerf closed unexpectedly. Your work on " + work.kept.name + " from " +
                fmt::format("{:%Y-%m-%d at %H:%M:%S}", fmt::localtime(work.when)) + ", with " +
                cuts + ", has not been saved.",
            {"Recover", "Discard", "Not now"},
            work.picture};
}

OpeningOrder orderOf(const LeftWork& work) {
    const auto open = [name = work.kept.name, session = work.kept.session,
                       journal = work.journal->file()](const ReadOptions& options) {
        try {
            return openScene(name, parseSession(session, {}), options);
        } catch (const InputError& error) {
            throw InputError(std::string(error.what()) + " Your work is still in " +
                             journal.string() + " and will be offered again at the next start.");
        }
    };
    return {"Recovering " + work.kept.name, {}, open};
}

}  // namespace kerf::app
