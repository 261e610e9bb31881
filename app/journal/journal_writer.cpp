#include "app/journal/journal_writer.h"

#include <fcntl.h>
#include <spdlog/fmt/chrono.h>
#include <unistd.h>

#include <atomic>
#include <ctime>

#include "app/journal/journal_text.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

/// By time, process and number: no two windows take the same.
std::string newName() {
    static std::atomic<int> count = 0;
    return fmt::format("{:%Y%m%d-%H%M%S}-{}-{}.journal", fmt::localtime(std::time(nullptr)),
                       ::getpid(), ++count);
}

}  // namespace

fs::path pictureOf(const fs::path& journal) {
    return fs::path(journal).replace_extension(".png");
}

void removeJournal(const fs::path& journal) {
    std::error_code error;
    fs::remove(pictureOf(journal), error);
    fs::remove(journal, error);
}

JournalWriter::JournalWriter(fs::path folder)
    : file_(std::move(folder.append(newName()))),
      hidden_(file_.parent_path() / ("." + file_.filename().string() + ".part")),
      thread_([this] { work(); }) {}

JournalWriter::~JournalWriter() {
    {
        const std::lock_guard hold(mutex_);
        ends_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void JournalWriter::add(Text text) {
    {
        const std::lock_guard hold(mutex_);
        if (failed_ || removed_) {
            return;
        }
        texts_.push_back(std::move(text));
    }
    wake_.notify_one();
}

void JournalWriter::run(std::function<void(const fs::path& journal)> work) {
    {
        const std::lock_guard hold(mutex_);
        if (failed_ || removed_) {
            return;
        }
        works_.push_back(std::move(work));
    }
    wake_.notify_one();
}

void JournalWriter::remove() {
    {
        const std::lock_guard hold(mutex_);
        removed_ = true;
        texts_.clear();
        works_.clear();
    }
    wake_.notify_one();
}

std::optional<std::string> JournalWriter::takeProblem() {
    const std::lock_guard hold(mutex_);
    return std::exchange(problem_, std::nullopt);
}

bool JournalWriter::settled() const {
    const std::lock_guard hold(mutex_);
    return !busy_ && texts_.empty() && works_.empty() && !problem_;
}

bool JournalWriter::flushed() const {
    const std::lock_guard hold(mutex_);
    return !busy_ && texts_.empty() && works_.empty() && !failed_;
}

bool JournalWriter::removed() const {
    const std::lock_guard hold(mutex_);
    return gone_;
}

void JournalWriter::work() {
    std::unique_lock hold(mutex_);
    while (true) {
        busy_ = false;
        wake_.wait(hold,
                   [this] { return ends_ || removed_ || !texts_.empty() || !works_.empty(); });
        if (removed_) {
            break;
        }
        if (!texts_.empty()) {
            busy_ = true;
            std::deque<Text> texts = std::exchange(texts_, {});
            hold.unlock();
            append(textOf(std::move(texts)));
        } else if (!works_.empty()) {
            busy_ = true;
            const auto next = std::move(works_.front());
            works_.pop_front();
            hold.unlock();
            try {
                next(file_);
            } catch (const std::exception&) {  // See run().
            }
        } else {
            return;
        }
        hold.lock();
    }
    removeJournal(file_);
    std::error_code error;
    fs::remove(hidden_, error);
    gone_ = true;
}

std::string JournalWriter::textOf(std::deque<Text> texts) {
    std::string all;
    try {
        for (Text& text : texts) {
            all += std::exchange(text, nullptr)();  // What it holds may be large.
        }
    } catch (const std::exception& error) {
        fail(error.what());
    }
    return all;
}

/// What has failed once is not tried again: half a line would stand in the midst.
void JournalWriter::append(const std::string& text) {
    try {
        if (text.empty() || failed_) {
            return;
        }
        bytes_ += text.size();
        if (bytes_ > kMaxJournalBytes) {
            fail("it would be larger than " + std::to_string(kMaxJournalBytes >> 20) + " MB");
            return;
        }
        const bool isNew = out_ == nullptr;
        if (isNew) {
            begin();
        }
        out_->write(text);
        out_->syncContent();
        if (isNew) {
            out_->rename(hidden_, file_);
            syncFolder(file_.parent_path());
        }
    } catch (const std::exception& error) {
        fail(error.what());
    }
}

/// Locked before anybody can see it under its name.
void JournalWriter::begin() {
    fs::create_directories(file_.parent_path());
    std::error_code error;
    fs::permissions(file_.parent_path(), fs::perms::owner_all, error);
    out_ =
        std::make_unique<SystemFile>(hidden_, O_WRONLY | O_CREAT | O_EXCL | O_APPEND, 0600U, file_);
    if (!out_->lock()) {
        throw OutputError(file_.string() + ": it could not be locked.");
    }
}

void JournalWriter::fail(const std::string& reason) {
    const std::lock_guard hold(mutex_);
    if (!std::exchange(failed_, true)) {
        texts_.clear();
        problem_ =
            "What you do from here on is not kept for the case that Kerf ends unexpectedly; "
            "save the session now and then. The reason: " +
            reason;
    }
}

}  // namespace kerf::app
