#include "app/editor/storage/work_keeping.h"

#include <spdlog/fmt/chrono.h>

#include "app/files/io/file_io.h"
#include "app/scene/timeline/scene_recorder.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr double kUntilPicture = 1;     // from the last change on [s]
constexpr double kBetweenSteps = 0.25;  // two notes of the time alone that has gone by [s]
constexpr int kPictureSide = 320;       // at most [px]

/// Smaller by a whole factor, so that neither side is longer than that.
render::Image smaller(const render::Image& image) {
    const int factor =
        std::max(1, (std::max(image.width, image.height) + kPictureSide - 1) / kPictureSide);
    render::Image small{image.width / factor, image.height / factor, {}};
    small.pixels.reserve(std::size_t(4) * small.width * small.height);
    for (int y = 0; y < small.height; ++y) {
        for (int i = 0; i < 4 * small.width; ++i) {
            int sum = 0;
            for (int k = 0; k < factor * factor; ++k) {
                const int row = factor * y + k / factor;
                const int column = factor * (i / 4) + k % factor;
                sum += image.pixels[std::size_t(4) * (row * image.width + column) + i % 4];
            }
            small.pixels.push_back(static_cast<std::uint8_t>(sum / (factor * factor)));
        }
    }
    return small;
}

}  // namespace

void WorkKeeping::begin(std::shared_ptr<Journal> left) {
    if (left != nullptr) {
        discard();
        journal_ = std::move(left);
    }
    begun_ = false;
    untilPicture_.reset();
    savedDeeds_ = 0;
}

void WorkKeeping::discard() {
    begun_ = false;
    untilPicture_.reset();
    if (journal_ != nullptr) {
        std::exchange(journal_, nullptr)->remove();
    }
}

bool WorkKeeping::leave() {
    const bool kept = journal_ != nullptr;
    journal_.reset();
    begin();
    return kept;
}

void WorkKeeping::follow(EditorScene& scene, const SavedView& seen,
                         const render::ChosenColors& colors, bool on, double elapsedSeconds) {
    if (!on || folder_.empty()) {
        discard();
        return;
    }
    if (untilPicture_ || !begun_) {
        untilPicture_ = untilPicture_
                            ? std::optional(std::max(0.0, *untilPicture_ - elapsedSeconds))
                            : std::nullopt;
        session_ = scene.recorder().sessionWithoutEvents(seen.camera, colors);
        session_.editor = seen;
    }
    if (!std::exchange(begun_, true)) {
        start(scene);
    } else if (isDue(scene)) {
        note(scene);
    }
}

void WorkKeeping::start(EditorScene& scene) {
    if (journal_ == nullptr) {
        journal_ = std::make_shared<Journal>(folder_);
    }
    const SessionChange all = scene.recorder().takeChange(true);
    unsaved_ = isUnsaved(scene.recorder().deeds());
    steps_ = all.steps;
    journal_->begin(scene.document().name, session_, all, unsaved_);
    if (unsaved_) {
        untilPicture_ = kUntilPicture;
    }
}

/// What is done is noted at once, or while steps run, as often as that takes a tenth of the time.
/// That time goes by is noted now and then.
bool WorkKeeping::isDue(EditorScene& scene) const {
    const bool isDone =
        !scene.timeline().log().isUnchanged() || isUnsaved(scene.recorder().deeds()) != unsaved_;
    const bool goesBy = scene.recorder().stepsAsSaved() != steps_ &&
                        (!scene.running() || sinceWrite_.seconds() > kBetweenSteps);
    return goesBy || (isDone && (!scene.running() || sinceWrite_.seconds() > 10 * lastWrite_));
}

void WorkKeeping::note(EditorScene& scene) {
    if (!scene.timeline().log().isUnchanged()) {
        untilPicture_ = kUntilPicture;
    }
    const Stopwatch watch;
    const SessionChange change = scene.recorder().takeChange(false);
    unsaved_ = isUnsaved(scene.recorder().deeds());
    steps_ = change.steps;
    journal_->write(change, unsaved_);
    lastWrite_ = watch.seconds();
    sinceWrite_.restart();
}

void WorkKeeping::keepPicture(const render::Image& picture) {
    untilPicture_.reset();
    journal_->show(session_, smaller(picture));
}

void WorkKeeping::noteSaved(int deeds) {
    savedDeeds_ = deeds;
    if (journal_ != nullptr && !journal_->works()) {
        discard();
    }
}

std::optional<std::string> WorkKeeping::takeProblem() {
    return journal_ == nullptr ? std::nullopt : journal_->takeProblem();
}

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
    const int count = work.kept.cuts();
    const std::string cuts = count == 0 ? "changes but no cuts" : counted(count, "cut", "cuts");
    return {"Recover unsaved work?",
            "Kerf closed unexpectedly. Your work on " + work.kept.name + " from " +
                fmt::format("{:%Y-%m-%d at %H:%M:%S}", fmt::localtime(work.kept.when)) + ", with " +
                cuts + ", has not been saved.",
            {"Recover", "Discard", "Not now"},
            work.picture};
}

OpeningOrder orderOf(const LeftWork& work) {
    const auto open = [name = work.kept.name, session = work.kept.text(),
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
