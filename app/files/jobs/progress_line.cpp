#include "app/files/jobs/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace kerf::app {

namespace {
constexpr std::chrono::milliseconds kRefresh{100};
}  // namespace

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
    if (shown_) {
        std::fputs("\r\x1b[K", stderr);
    }
}

void ProgressLine::show(int done, int total) {
    const auto now = Clock::now();
    if (!terminal_ || now - last_ < kRefresh) {
        return;
    }
    last_ = now;
    shown_ = true;
    std::fprintf(stderr, "\r%sstep %d of %d (%d %%)\x1b[K", what_.c_str(), done, total,
                 static_cast<int>(100.0 * done / total));
    std::fflush(stderr);
}

}  // namespace kerf::app
