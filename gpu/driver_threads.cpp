#include "gpu/driver_threads.h"

#include <sched.h>

#include <fstream>
#include <system_error>

namespace kerf::gpu {

std::vector<int> processors() {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    std::vector<int> numbers;
    if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0) {
        for (int number = 0; number < CPU_SETSIZE; ++number) {
            if (CPU_ISSET(number, &allowed)) {
                numbers.push_back(number);
            }
        }
    }
    return numbers;
}

void moveThread(pid_t thread, int processor) {
    cpu_set_t own;
    CPU_ZERO(&own);
    CPU_SET(processor, &own);
    sched_setaffinity(thread, sizeof(own), &own);
}

namespace {

/// The threads of llvmpipe in this process, by their names, "llvmpipe-0" and so on.
std::map<std::string, pid_t> driverThreads() {
    constexpr std::string_view kName = "llvmpipe-";
    std::map<std::string, pid_t> threads;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", error)) {
        std::ifstream file(entry.path() / "comm");
        std::string name;
        if (std::getline(file, name) && name.starts_with(kName)) {
            threads[name] = static_cast<pid_t>(std::stol(entry.path().filename().string()));
        }
    }
    return threads;
}

}  // namespace

void spreadDriverThreads() {
    const std::vector<int> places = processors();
    const std::map<std::string, pid_t> threads = driverThreads();
    if (threads.size() < 2 || threads.size() != places.size()) {
        return;
    }
    auto place = places.begin();
    for (const auto& [name, thread] : threads) {
        moveThread(thread, *place++);
    }
}

}  // namespace kerf::gpu
