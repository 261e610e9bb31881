#include "app/files/jobs/background_job.h"

#include <sys/resource.h>
#include <unistd.h>

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

void lowerThreadPriority() {
    constexpr int kNice = 5;
    // On Linux the priority belongs to the thread. Where it can't be changed, work goes on as is.
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
}

}  // namespace kerf::app
