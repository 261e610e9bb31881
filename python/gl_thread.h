#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <type_traits>

namespace kerf::python {

/// The module was used before a fork, and is used again in the child: OpenGL does not survive that.
class ForkedProcess : public std::runtime_error {
  public:
    ForkedProcess();
};

/// The module's one thread for OpenGL. A context belongs to one thread at a time, and what Kerf
/// shares between contexts to a single thread, while Python may call from any thread.
class GlThread {
  public:
    /// The thread of this process; begins at the first use and never ends.
    static GlThread& ours();

    /// Runs `work` there, without Python's lock, and returns or throws what it does. To be called
    /// with Python's lock. A signal that Python raises for, such as Ctrl-C, asks the work to stop
    /// (interrupted()), and is raised at its end. Throws ForkedProcess.
    template <class Work>
    auto run(Work&& work) {
        using Result = std::invoke_result_t<Work>;
        if constexpr (std::is_void_v<Result>) {
            waitFor([&] { work(); });
        } else {
            std::optional<Result> result;
            waitFor([&] { result.emplace(work()); });
            return std::move(*result);
        }
    }
    /// Runs work there without waiting for an answer; it must not throw.
    void post(std::function<void()> work);

    /// Whether the work that runs there now, and asks, should stop soon.
    bool interrupted() const { return current_ != nullptr && current_->interrupted; }

  private:
    /// Work that a caller waits for.
    struct Job {
        const std::function<void()>& work;
        std::exception_ptr error;
        bool done = false;
        std::atomic<bool> interrupted = false;
    };
    GlThread();
    void loop();
    void waitFor(const std::function<void()>& work);
    void perform(Job& job);
    void requireSameProcess() const;

    const int process_;
    std::mutex mutex_;
    std::condition_variable asked_;
    std::condition_variable answered_;
    std::deque<std::function<void()>> queue_;
    Job* current_ = nullptr;  ///< for its own thread alone
};

}  // namespace kerf::python
