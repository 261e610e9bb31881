#pragma once

#include <boost/context/fiber.hpp>
#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "sim/base/stopwatch.h"

namespace kerf::app {

/// Work of this thread in portions: a fiber with its own stack that pauses at pausePoint()s. The
/// OpenGL context is the same, so code between two portions may read what the work writes, but must
/// not change it.
class WorkInPortions {
  public:
    /// `check`: of Pauses.
    explicit WorkInPortions(std::function<std::string()> check = {}) : check_(std::move(check)) {}
    ~WorkInPortions() { giveUp(); }
    WorkInPortions(const WorkInPortions&) = delete;
    WorkInPortions& operator=(const WorkInPortions&) = delete;

    /// Takes work, which starts with goOn(). There must be none in progress.
    void begin(std::function<void()> work);
    bool underWay() const { return static_cast<bool>(work_); }
    /// Whether the caller is the work.
    bool isWorking() const { return working_; }
    /// Continues for about `seconds`, up to the next pausePoint(). Throws what the work throws,
    /// which ends it.
    void goOn(double seconds);
    /// Completes the work. Throws what it throws.
    void finish();
    /// Cancels the work: its stack is unwound.
    void giveUp() { work_ = {}; }
    /// Since it was begun [s].
    double seconds() const { return underWay() ? sinceBegun_.seconds() : 0; }

  private:
    using Fiber = boost::context::fiber;
    Fiber run(Fiber&& caller, const std::function<void()>& work);
    void rest();
    void resume();

    Fiber work_;  ///< where it pauses; none without work
    Fiber caller_;
    bool working_ = false;
    double portion_ = 0;  ///< [s]
    Stopwatch sinceResumed_, sinceBegun_;
    std::exception_ptr failure_;
    std::function<std::string()> check_;
};

}  // namespace kerf::app
