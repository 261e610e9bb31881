#include "app/files/jobs/saving_queue.h"

#include <exception>
#include <new>

#include "app/files/io/memory_means.h"

namespace kerf::app {

SavingQueue::Outcome SavingQueue::endOf(BackgroundJob<std::string>& job, int number) {
    try {
        return {number, job.take(), false};
    } catch (const std::bad_alloc&) {
        return {number, outOfMemory("Saving"), true};
    } catch (const std::exception& error) {
        return {number, error.what(), true};
    }
}

int SavingQueue::add(Work work) {
    waiting_.push_back(std::move(work));
    if (!busy()) {
        startNext();
    }
    return ++added_;
}

void SavingQueue::startNext() {
    if (waiting_.empty()) {
        return;
    }
    running_ = std::make_unique<BackgroundJob<std::string>>(
        [work = std::move(waiting_.front())](WorkProgress&) { return work(); });
    waiting_.pop_front();
}

std::optional<SavingQueue::Outcome> SavingQueue::takeOutcome() {
    if (!busy() || !running_->done()) {
        return std::nullopt;
    }
    const Outcome outcome = endOf(*std::exchange(running_, nullptr), ++ended_);
    startNext();
    return outcome;
}

void SavingQueue::finish() {
    while (busy()) {
        running_->wait();
        takeOutcome();
    }
}

}  // namespace kerf::app
