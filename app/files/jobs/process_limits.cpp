#include "app/files/jobs/process_limits.h"

#include <sys/resource.h>

#include <cstdlib>

namespace kerf::app {

namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitAddressSpace = false;  // AddressSanitizer reserves terabytes.
#else
constexpr bool kLimitAddressSpace = true;
#endif

void setLimit(__rlimit_resource resource, rlim_t value) {
    rlimit limit{};
    ::getrlimit(resource, &limit);
    limit.rlim_cur = std::min(value, limit.rlim_max);
    ::setrlimit(resource, &limit);
}

void setLimitFrom(const char* variable, __rlimit_resource resource) {
    const char* text = std::getenv(variable);
    if (text != nullptr) {
        setLimit(resource, std::strtoull(text, nullptr, 10));
    }
}

constexpr rlim_t kMendingSeconds = kMendingWallSeconds;
constexpr rlim_t kMendingBytes = rlim_t{16} << 30;

}  // namespace

void limitProcessorTime(unsigned seconds) {
    setLimit(RLIMIT_CPU, seconds);
}

void allowMending() {
    limitProcessorTime(kMendingSeconds);
    if (kLimitAddressSpace) {
        setLimit(RLIMIT_AS, kMendingBytes);
    }
}

void applyImportLimits() {
    setLimit(RLIMIT_CORE, 0);
    setLimitFrom(kCpuVariable, RLIMIT_CPU);
    if (kLimitAddressSpace) {
        setLimitFrom(kMemoryVariable, RLIMIT_AS);
    }
}

}  // namespace kerf::app
