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

void WorkKeeping::begin(std::shared_ptr<LeftJournal> left) {
    discard();
    left_ = std::move(left);
    savedDeeds_ = 0;
}

void WorkKeeping::discard() {
    giveUpWriter();
    if (left_ != nullptr) {
        std::exchange(left_, nullptr)->remove();
    }
}

bool WorkKeeping::leave() {
    untilPicture_.reset();
    savedDeeds_ = 0;
    const bool kept = writer_ != nullptr || left_ != nullptr;
    writer_.reset();
    left_.reset();
    return kept;
}

void WorkKeeping::giveUpWriter() {
    untilPicture_.reset();
    if (writer_ != nullptr) {
        writer_->remove();
        ended_.push_back(std::move(writer_));
    }
}

void WorkKeeping::follow(EditorScene& scene, const render::Camera& camera,
                         const render::ChosenColors& colors, bool on, double elapsedSeconds) {
    std::erase_if(ended_, [](const auto& writer) { return writer->removed(); });
    if (!on || folder_.empty()) {
        giveUpWriter();
        return;
    }
    if (untilPicture_) {
        *untilPicture_ = std::max(0.0, *untilPicture_ - elapsedSeconds);
        session_ = scene.recorder().sessionWithoutEvents(camera, colors);
    }
    if (writer_ == nullptr) {
        start(scene, scene.recorder().sessionWithoutEvents(camera, colors));
    } else {
        note(scene);
    }
    if (left_ != nullptr && writer_->flushed()) {
        std::exchange(left_, nullptr)->remove();
    }
}

void WorkKeeping::start(EditorScene& scene, Session session) {
    writer_ = std::make_unique<JournalWriter>(folder_);
    hashes_ = std::make_shared<ModelHashes>();
    writer_->add([name = scene.document().name, session = std::move(session), hashes = hashes_] {
        Session hashed = session;
        addHashes(hashed, *hashes);
        return journalStart(name, hashed);
    });
    write(scene.recorder().takeChange(true), isUnsaved(scene.recorder().deeds()));
    if (isUnsaved(scene.recorder().deeds())) {
        untilPicture_ = kUntilPicture;
    }
}

/// That time goes by is noted now and then; what is done, at once.
void WorkKeeping::note(EditorScene& scene) {
    SessionChange change = scene.recorder().takeChange(false);
    const bool unsaved = isUnsaved(scene.recorder().deeds());
    const bool isDone = change.dropped > 0 || !change.added.empty();
    const bool goesBy =
        change.steps != steps_ && (!scene.running() || sinceLine_.seconds() > kBetweenSteps);
    if (isDone || goesBy || unsaved != unsaved_) {
        untilPicture_ = isDone ? std::optional(kUntilPicture) : untilPicture_;
        write(std::move(change), unsaved);
    }
}

void WorkKeeping::write(SessionChange change, bool unsaved) {
    steps_ = change.steps;
    unsaved_ = unsaved;
    sinceLine_.restart();
    writer_->add([change = std::move(change), unsaved] { return journalLine(change, unsaved); });
}

bool WorkKeeping::settled() const {
    const bool leftGoes = left_ != nullptr && writer_ != nullptr && writer_->flushed();
    return ended_.empty() && !leftGoes && (writer_ == nullptr || writer_->settled());
}

std::optional<double> WorkKeeping::pictureDue() const {
    return untilPicture_;
}

void WorkKeeping::keepPicture(render::Image picture) {
    untilPicture_.reset();
    writer_->add([session = session_, hashes = hashes_] {
        Session hashed = session;
        addHashes(hashed, *hashes);
        return journalView(hashed);
    });
    writer_->run([picture = std::move(picture)](const std::filesystem::path& journal) {
        writePicture(smaller(picture), pictureOf(journal));
    });
}

std::optional<std::string> WorkKeeping::takeProblem() {
    return writer_ == nullptr ? std::nullopt : writer_->takeProblem();
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
