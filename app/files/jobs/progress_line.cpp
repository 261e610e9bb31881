#include "app/files/jobs/progress_line.h"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <cstdio>

namespace kerf::app {

namespace {

constexpr double kRefresh = 0.1;  // [s]
constexpr double kSettles = 2;    // until which there is no rate to go by [s]

/// "about 20 s left".
std::string leftText(double seconds) {
    constexpr double kMinute = 60;
    if (seconds >= 2 * kMinute) {
        return fmt::format("about {:.0f} min left", seconds / kMinute);
    }
    const double step = seconds < 10 ? 1 : 5;
    return fmt::format("about {:.0f} s left", step * std::ceil(seconds / step));
}

}  // namespace

std::string progressText(int done, int total, double seconds) {
    const std::string left =
        done > 0 && seconds >= kSettles ? ", " + leftText(seconds / done * (total - done)) : "";
    return fmt::format("step {} of {} ({} %){}", done, total,
                       static_cast<int>(100.0 * done / total), left);
}

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
    if (shown_) {
        std::fputs("\r\x1b[K", stderr);
    }
}

void ProgressLine::show(int done, int total) {
    if (!watch_) {
        watch_.emplace();
    }
    const double now = watch_->seconds();
    if (!terminal_ || now - last_ < kRefresh) {
        return;
    }
    last_ = now;
    shown_ = true;
    std::fprintf(stderr, "\r%s%s\x1b[K", what_.c_str(), progressText(done, total, now).c_str());
    std::fflush(stderr);
}

}  // namespace kerf::app
