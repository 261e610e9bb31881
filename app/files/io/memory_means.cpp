#include "app/files/io/memory_means.h"

#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <mutex>

#include "gpu/context.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

constexpr char kVariable[] = "KERF_MEMORY_BYTES";
// Addresses that a software driver maps without using them; Mesa crashes where they are missing.
constexpr std::uint64_t kDriverReserves = 200'000'000;
constexpr double kMega = 1e6;
constexpr double kGiga = 1e9;

/// "1.2 GB", or "34 MB" where it is less than one.
std::string quantity(std::uint64_t bytes) {
    const auto amount = static_cast<double>(bytes);
    return amount < kGiga ? fmt::format("{:.0f} MB", amount / kMega)
                          : fmt::format("{:.1f} GB", amount / kGiga);
}

/// The number behind `name` in a file of lines "name: number kB" [bytes].
std::optional<std::uint64_t> numberIn(const char* file, std::string_view name) {
    std::ifstream in(file);
    std::string key;
    std::uint64_t kilobytes = 0;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with(name) && line.size() > name.size() && line[name.size()] == ':') {
            kilobytes = std::strtoull(line.c_str() + name.size() + 1, nullptr, 10);
            return kilobytes * 1024;
        }
    }
    return std::nullopt;
}

/// The only number in a file; none where it says "max".
std::optional<std::uint64_t> numberOf(const fs::path& file) {
    std::ifstream in(file);
    std::uint64_t number = 0;
    return in >> number ? std::optional(number) : std::nullopt;
}

std::uint64_t lessOf(std::uint64_t limit, std::uint64_t used) {
    return limit > used ? limit - used : 0;
}

/// The names that the kernel gives to the limit of a control group and to what of it is in use.
struct GroupFiles {
    const char* limit;
    const char* used;
};

/// What the groups from `group` up to `root` leave.
std::uint64_t leftByGroups(const fs::path& root, fs::path group, const GroupFiles& files) {
    std::uint64_t left = MemoryMeans::kNoLimit;
    while (true) {
        const fs::path folder = root / group.relative_path();
        const auto limit = numberOf(folder / files.limit);
        const auto used = numberOf(folder / files.used);
        if (limit && used) {
            left = std::min(left, lessOf(*limit, *used));
        }
        if (!group.has_relative_path()) {
            return left;
        }
        group = group.parent_path();
    }
}

/// Of both versions of control groups, in each of the groups that this process is in.
std::uint64_t leftByGroups() {
    std::uint64_t left = MemoryMeans::kNoLimit;
    std::ifstream in("/proc/self/cgroup");
    for (std::string line; std::getline(in, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) {
            continue;
        }
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const fs::path group = line.substr(second + 1);
        if (controllers.empty()) {
            left = std::min(
                left, leftByGroups("/sys/fs/cgroup", group, {"memory.max", "memory.current"}));
        } else if (controllers == "memory") {
            left = std::min(left, leftByGroups("/sys/fs/cgroup/memory", group,
                                               {"memory.limit_in_bytes", "memory.usage_in_bytes"}));
        }
    }
    return left;
}

std::uint64_t leftByLimit(__rlimit_resource resource, std::string_view usage) {
    rlimit limit{};
    if (::getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
        return MemoryMeans::kNoLimit;
    }
    return lessOf(limit.rlim_cur, numberIn("/proc/self/status", usage).value_or(0));
}

std::uint64_t leftByVariable() {
    const char* const text = std::getenv(kVariable);
    if (text == nullptr) {
        return MemoryMeans::kNoLimit;
    }
    const std::string_view digits = text;
    std::uint64_t bytes = 0;
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), bytes);
    if (error != std::errc{} || end != digits.end()) {
        static std::once_flag told;
        std::call_once(told, [text] {
            spdlog::warn("{} is no number of bytes and counts for nothing: {}", kVariable, text);
        });
        return MemoryMeans::kNoLimit;
    }
    return bytes;
}

}  // namespace

std::uint64_t freeMemory() {
    return std::min({numberIn("/proc/meminfo", "MemAvailable").value_or(MemoryMeans::kNoLimit),
                     leftByGroups(), leftByLimit(RLIMIT_AS, "VmSize"),
                     leftByLimit(RLIMIT_DATA, "VmData"), leftByVariable()});
}

MemoryMeans memoryMeans() {
    const std::uint64_t addresses = leftByLimit(RLIMIT_AS, "VmSize");
    const bool limited = addresses != MemoryMeans::kNoLimit;
    return {.free = limited ? std::min(freeMemory(), lessOf(addresses, kDriverReserves))
                            : freeMemory()};
}

MemoryMeans memoryMeansOfContext() {
    GLint64 largest = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
    return {.free = freeMemory(),
            .holdsGraphics = gpu::queryDevice().software,
            .largestBuffer = static_cast<std::uint64_t>(largest)};
}

void requireMemory(const std::string& what, const MemoryNeed& need, const MemoryMeans& means) {
    const std::uint64_t wanted = need.memory + (means.programRuns ? 0 : need.program) +
                                 (means.holdsGraphics ? need.graphics : 0);
    if (wanted > means.free) {
        throw MemoryShortage(
            fmt::format("{}: cutting it needs about {} of memory, and {} are free; close other "
                        "programs, or make a coarser model of it with kerf inspect MODEL "
                        "--remesh OUT.ply --edge LENGTH.",
                        what, quantity(wanted), quantity(means.free)));
    }
    if (need.largestBuffer > means.largestBuffer) {
        throw MemoryShortage(
            fmt::format("{}: cutting it needs a graphics buffer of {}, and this driver allows {} "
                        "at most; make a coarser model of it with kerf inspect MODEL --remesh "
                        "OUT.ply --edge LENGTH.",
                        what, quantity(need.largestBuffer), quantity(means.largestBuffer)));
    }
}

void requireFree(const std::string& what, double bytes, const std::string& help) {
    const std::uint64_t free = freeMemory();
    if (bytes > static_cast<double>(free)) {
        constexpr double kMost = 1e18;  // that is counted
        throw MemoryShortage(fmt::format(
            "{}, which takes about {} of memory, and {} are free; {}.", what,
            quantity(static_cast<std::uint64_t>(std::min(bytes, kMost))), quantity(free), help));
    }
}

std::string describeMemory(const MemoryNeed& need, std::uint64_t free) {
    return fmt::format("about {} to cut it, and {} of graphics memory; {} are free here",
                       quantity(need.memory + need.program), quantity(need.graphics),
                       quantity(free));
}

std::string outOfMemory(const std::string& doing) {
    return fmt::format(
        "{} ran out of memory; close other programs, or make a coarser model with kerf inspect "
        "MODEL --remesh OUT.ply --edge LENGTH.",
        doing);
}

}  // namespace kerf::app
