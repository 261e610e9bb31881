#include "app/editor/steps/scene_at_work.h"

#include <boost/context/protected_fixedsize_stack.hpp>
#include <cassert>

#include "sim/base/freed_memory.h"
#include "sim/base/pausing.h"

namespace kerf::app {

namespace {

constexpr std::size_t kStackBytes = std::size_t{8} << 20;  // as the main thread's

}  // namespace

void WorkInPortions::begin(std::function<void()> work) {
    assert(!underWay() && "one at a time");
    sinceBegun_.restart();
    work_ = Fiber(
        std::allocator_arg, boost::context::protected_fixedsize_stack(kStackBytes),
        [this, work = std::move(work)](Fiber&& caller) { return run(std::move(caller), work); });
}

WorkInPortions::Fiber WorkInPortions::run(Fiber&& caller, const std::function<void()>& work) {
    caller_ = std::move(caller);
    try {
        work();
    } catch (const boost::context::detail::forced_unwind&) {
        throw;
    } catch (...) {
        failure_ = std::current_exception();
    }
    return std::move(caller_);
}

void WorkInPortions::rest() {
    if (sinceResumed_.seconds() >= portion_) {
        caller_ = std::move(caller_).resume();
    }
}

void WorkInPortions::resume() {
    sinceResumed_.restart();
    working_ = true;
    {
        const Pauses pauses([this] { rest(); }, check_);
        work_ = std::move(work_).resume();
    }
    working_ = false;
    if (failure_) {
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

void WorkInPortions::goOn(double seconds) {
    if (underWay()) {
        portion_ = seconds;
        resume();
    }
}

void WorkInPortions::finish() {
    goOn(std::numeric_limits<double>::infinity());
}

void SceneAtWork::set(std::unique_ptr<EditorScene> scene) {
    work_.giveUp();
    waiting.clear();
    onceSought = nullptr;
    scene_ = std::move(scene);
    giveBackFreedMemory();
}

std::unique_ptr<EditorScene> SceneAtWork::exchange(std::unique_ptr<EditorScene> scene) {
    return std::exchange(scene_, std::move(scene));
}

EditorScene* SceneAtWork::get() {
    if (!work_.isWorking()) {
        work_.finish();
    }
    return scene_.get();
}

void SceneAtWork::begin(SceneWork kind, std::function<void(EditorScene&)> work) {
    kind_ = kind;
    work_.begin([work = std::move(work), scene = scene_.get()] { work(*scene); });
}

}  // namespace kerf::app
