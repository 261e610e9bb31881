#include "gpu/timer.h"

#include <glad/gl.h>

#include <cassert>

#include "gpu/context.h"

namespace kerf::gpu {
namespace {

constexpr double kMillisecondsPerNanosecond = 1e-6;

std::uint64_t nanoseconds(std::uint32_t query) {
    GLuint64 time = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &time);
    return time;
}

}  // namespace

Timer::~Timer() {
    if (!queries_.empty()) {
        glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
    }
}

void Timer::begin() {
    assert(used_ % 2 == 0 && "begin() follows end()");
    glQueryCounter(nextQuery(), GL_TIMESTAMP);
}

void Timer::end() {
    assert(used_ % 2 == 1 && "end() follows begin()");
    glQueryCounter(nextQuery(), GL_TIMESTAMP);
}

double Timer::takeMilliseconds() {
    assert(used_ % 2 == 0 && "take follows end()");
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < used_; i += 2) {
        sum += nanoseconds(queries_[i + 1]) - nanoseconds(queries_[i]);
    }
    used_ = 0;
    return static_cast<double>(sum) * kMillisecondsPerNanosecond;
}

std::uint32_t Timer::nextQuery() {
    if (used_ == queries_.size()) {
        GLuint query = 0;
        glCreateQueries(GL_TIMESTAMP, 1, &query);
        queries_.push_back(query);
    }
    return queries_[used_++];
}

ComputeTimer::ComputeTimer() : byClock_(queryDevice().renderer.starts_with("llvmpipe")) {}

void ComputeTimer::begin() {
    if (!byClock_) {
        timer_.begin();
    }
    start_ = Clock::now();
}

void ComputeTimer::end() {
    if (byClock_) {
        milliseconds_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    } else {
        timer_.end();
    }
}

double ComputeTimer::takeMilliseconds() {
    return byClock_ ? std::exchange(milliseconds_, 0) : timer_.takeMilliseconds();
}

}  // namespace kerf::gpu
