#pragma once

#include <boost/context/fiber.hpp>
#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "sim/base/stopwatch.h"

namespace kerf::app {

/// Work of this thread that is done in portions: it has a stack of its own and rests at
/// pausePoint()s. OpenGL's context is the same, so whoever draws between two portions may read what
/// the work writes, but must change nothing of it.
class WorkInPortions {
  public:
    /// `check`: of Pauses.
    explicit WorkInPortions(std::function<std::string()> check = {}) : check_(std::move(check)) {}
    ~WorkInPortions() { giveUp(); }
    WorkInPortions(const WorkInPortions&) = delete;
    WorkInPortions& operator=(const WorkInPortions&) = delete;

    /// Takes work, of which nothing is done before goOn(). There must be none under way.
    void begin(std::function<void()> work);
    bool underWay() const { return static_cast<bool>(work_); }
    /// Whether it is the work that asks.
    bool isWorking() const { return working_; }
    /// Goes on for about `seconds`, up to the next pausePoint(). Throws what the work throws, which
    /// ends it.
    void goOn(double seconds);
    /// Goes on to the end. Throws what the work throws.
    void finish();
    /// Gives up what is under way: its stack is unwound.
    void giveUp() { work_ = {}; }
    /// Since it was begun [s].
    double seconds() const { return underWay() ? sinceBegun_.seconds() : 0; }

  private:
    using Fiber = boost::context::fiber;
    Fiber run(Fiber&& caller, const std::function<void()>& work);
    void rest();
    void resume();

    Fiber work_;  ///< where it rests; none while none is under way
    Fiber caller_;
    bool working_ = false;
    double portion_ = 0;  ///< [s]
    Stopwatch sinceResumed_, sinceBegun_;
    std::exception_ptr failure_;
    std::function<std::string()> check_;
};

}  // namespace kerf::app
