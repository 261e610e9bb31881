#include "python/gl_thread.h"

#include <pybind11/pybind11.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace kerf::python {
namespace {

namespace py = pybind11;

constexpr std::chrono::milliseconds kSignalPoll{50};

}  // namespace

ForkedProcess::ForkedProcess()
    : std::runtime_error(
          "Kerf was used before this process was forked, and OpenGL does not survive that. Start "
          "processes by \"spawn\", or use kerf in the child alone.") {}

GlThread& GlThread::ours() {
    static auto* const thread = new GlThread;  // its loop outlives the statics
    return *thread;
}

GlThread::GlThread() : process_(::getpid()) {
    std::thread([this] { loop(); }).detach();
}

void GlThread::loop() {
    for (;;) {
        std::function<void()> work;
        {
            std::unique_lock lock(mutex_);
            asked_.wait(lock, [this] { return !queue_.empty(); });
            work = std::move(queue_.front());
            queue_.pop_front();
        }
        work();
    }
}

void GlThread::post(std::function<void()> work) {
    {
        const std::lock_guard lock(mutex_);
        queue_.push_back(std::move(work));
    }
    asked_.notify_one();
}

void GlThread::requireSameProcess() const {
    if (::getpid() != process_) {
        throw ForkedProcess();
    }
}

void GlThread::perform(Job& job) {
    current_ = &job;
    try {
        job.work();
    } catch (...) {
        job.error = std::current_exception();
    }
    current_ = nullptr;
    {
        const std::lock_guard lock(mutex_);
        job.done = true;
        answered_.notify_all();  // under the lock: the job goes as soon as it is seen to be done
    }
}

void GlThread::waitFor(const std::function<void()>& work) {
    requireSameProcess();
    Job job{.work = work, .error = {}};
    {
        const py::gil_scoped_release unlocked;
        post([this, &job] { perform(job); });
        std::unique_lock lock(mutex_);
        const auto done = [&job] { return job.done; };
        while (!answered_.wait_for(lock, kSignalPoll, done)) {
            lock.unlock();
            {
                const py::gil_scoped_acquire locked;
                job.interrupted = job.interrupted || PyErr_CheckSignals() != 0;
            }
            lock.lock();
        }
    }
    if (job.interrupted) {
        throw py::error_already_set();
    }
    if (job.error) {
        std::rethrow_exception(job.error);
    }
}

}  // namespace kerf::python
