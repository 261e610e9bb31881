#include "app/files/jobs/work_progress.h"

#include <utility>

namespace kerf::app {

void WorkProgress::enter(std::string stage, int done, int all) {
    if (cancelled_) {
        throw WorkCancelled();
    }
    const std::lock_guard lock(mutex_);
    stage_ = std::move(stage);
    done_ = done;
    all_ = all;
}

std::string WorkProgress::stage() const {
    const std::lock_guard lock(mutex_);
    return stage_;
}

}  // namespace kerf::app
