#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <latch>
#include <thread>

#include "gpu/prompt_waits.h"

namespace kerf::gpu {
namespace {

/// Where threads with these names may run once the driver's threads are spread.
std::vector<cpu_set_t> spread(const std::vector<std::string>& names) {
    std::vector<cpu_set_t> places(names.size());
    std::latch named(static_cast<std::ptrdiff_t>(names.size()) + 1);
    std::latch isSpread(1);
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < names.size(); ++i) {
        threads.emplace_back([&, i] {
            pthread_setname_np(pthread_self(), names[i].c_str());
            named.arrive_and_wait();
            isSpread.wait();
            sched_getaffinity(0, sizeof(places[i]), &places[i]);
        });
    }
    named.arrive_and_wait();
    spreadDriverThreads();
    isSpread.count_down();
    threads.clear();
    return places;
}

std::vector<std::string> namesOf(int count) {
    std::vector<std::string> names;
    names.reserve(count);
    for (int i = 0; i < count; ++i) {
        names.push_back("llvmpipe-" + std::to_string(i));
    }
    return names;
}

int processorCount() {
    cpu_set_t all;
    sched_getaffinity(0, sizeof(all), &all);
    return CPU_COUNT(&all);
}

TEST(DriverThreads, HaveAProcessorEach) {
    const int count = processorCount();
    if (count < 2) {
        GTEST_SKIP() << "one processor";
    }
    const std::vector<cpu_set_t> places = spread(namesOf(count));
    cpu_set_t all;
    CPU_ZERO(&all);
    for (const cpu_set_t& place : places) {
        EXPECT_EQ(CPU_COUNT(&place), 1);
        CPU_OR(&all, &all, &place);
    }
    EXPECT_EQ(CPU_COUNT(&all), count);
}

TEST(DriverThreads, StayWhereTheyAreWhereThereAreFewerOrOthers) {
    const int count = processorCount();
    for (const std::vector<std::string>& names :
         {namesOf(1), std::vector<std::string>(count, "worker")}) {
        for (const cpu_set_t& place : spread(names)) {
            EXPECT_EQ(CPU_COUNT(&place), count);
        }
    }
}

}  // namespace
}  // namespace kerf::gpu
