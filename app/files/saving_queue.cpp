#include "app/files/saving_queue.h"

#include <exception>
#include <utility>

namespace kerf::app {

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

void SavingQueue::takeRunning() {
    ++ended_;
    try {
        outcomes_.push_back({ended_, running_->take(), false});
    } catch (const std::exception& error) {
        outcomes_.push_back({ended_, error.what(), true});
    }
    running_.reset();
    startNext();
}

std::vector<SavingQueue::Outcome> SavingQueue::takeOutcomes() {
    if (busy() && running_->done()) {
        takeRunning();
    }
    return std::exchange(outcomes_, {});
}

void SavingQueue::finish() {
    while (busy()) {
        running_->wait();
        takeRunning();
    }
}

}  // namespace kerf::app
