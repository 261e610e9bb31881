#include "app/files/jobs/background_job.h"

#include <sys/resource.h>
#include <unistd.h>

namespace kerf::app {

void lowerThreadPriority() {
    constexpr int kNice = 5;
    // On Linux the priority belongs to the thread. Where it can't be changed, work goes on as is.
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
}

}  // namespace kerf::app
