#include "gpu/read_back.h"

#include <glad/gl.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <cassert>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "gpu/context.h"
#include "gpu/gl_name.h"
#include "gpu/traffic.h"

namespace kerf::gpu {
namespace {

constexpr GLbitfield kAccess = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
constexpr std::size_t kAlignment = 16;  // of each place, for whatever type is read there [bytes]

struct Mapping {
    GLuint id = 0;
    const std::byte* memory = nullptr;
};

Mapping allocateMapped(std::size_t bytes) {
    forgetErrors();
    Mapping made;
    const auto size = static_cast<GLsizeiptr>(bytes);
    glCreateBuffers(1, &made.id);
    try {
        glNamedBufferStorage(made.id, size, nullptr, kAccess);
        throwIfOutOfMemory("a mapped buffer", bytes);
        made.memory =
            static_cast<const std::byte*>(glMapNamedBufferRange(made.id, 0, size, kAccess));
        throwIfOutOfMemory("the view of a mapped buffer", bytes);
        if (made.memory == nullptr) {
            throw std::runtime_error("The graphics driver does not map a buffer for reading.");
        }
    } catch (...) {
        glDeleteBuffers(1, &made.id);
        throw;
    }
    return made;
}

/// However long it takes: large bodies on slow machines need seconds.
void waitFor(GLsync fence) {
    constexpr GLuint64 kTurn = 1'000'000'000;  // [ns]
    GLenum state = GL_TIMEOUT_EXPIRED;
    while (state == GL_TIMEOUT_EXPIRED) {
        state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kTurn);
    }
    requireContext();
    if (state == GL_WAIT_FAILED) {
        throw std::runtime_error("Waiting for the graphics driver failed.");
    }
}

void warnOnceOfEarlyFence() {
    static bool warned = false;
    if (!std::exchange(warned, true)) {
        spdlog::warn("The graphics driver told of results too early; Kerf waits for them.");
    }
}

}  // namespace

ReadBack::~ReadBack() {
    release();
}

std::size_t ReadBack::ask(const Buffer& from, std::size_t bytes) {
    assert(bytes <= from.size() && "asked beyond the size in use");
    const std::size_t place = asked_;
    parts_.push_back({from.id(), place, bytes});
    asked_ += (bytes + kAlignment - 1) / kAlignment * kAlignment;
    return place;
}

void ReadBack::send() {
    const std::vector<Part> parts = std::exchange(parts_, {});
    markPlace_ = std::exchange(asked_, 0);
    reserve(markPlace_ + kAlignment);
    dropFence();
    updateBarrier();
    for (const Part& part : parts) {
        if (part.bytes > 0) {
            glCopyNamedBufferSubData(part.buffer, id_, 0, static_cast<GLintptr>(part.place),
                                     static_cast<GLsizeiptr>(part.bytes));
        }
        traffic().bytesDown += part.bytes;
    }
    mark();
    barrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (fence_ == nullptr) {
        throw std::runtime_error("The graphics driver gives no fence to wait for.");
    }
    glFlush();  // so that the GPU works while the CPU does something else
}

const std::byte* ReadBack::awaited(std::size_t place, [[maybe_unused]] std::size_t bytes) const {
    assert(place + bytes <= capacity_ && "read beyond what was sent");
    if (fence_ != nullptr) {
        wait();
        dropFence();
    }
    return memory_ + place;
}

/// The copies are there once their mark is, which is a copy too: a clear may come earlier. No two
/// in a process are alike: memory comes back.
void ReadBack::mark() {
    static std::uint32_t last = 0;
    serial_ = ++last;
    markSource_.assign(std::span<const std::uint32_t>(&serial_, 1));
    glCopyNamedBufferSubData(markSource_.id(), id_, 0, static_cast<GLintptr>(markPlace_),
                             sizeof(serial_));
}

bool ReadBack::isMarked() const {
    return *reinterpret_cast<const volatile std::uint32_t*>(memory_ + markPlace_) == serial_;
}

void ReadBack::wait() const {
    ++traffic().waits;
    waitFor(static_cast<GLsync>(fence_));
    if (!isMarked()) {
        warnOnceOfEarlyFence();
        waitForMark();
    }
}

/// Zink of Mesa 22.3 was seen to signal a fence some milliseconds before the copies were done, and
/// to end a glFinish() as early (docs/notes/drivers.md).
void ReadBack::waitForMark() const {
    constexpr std::chrono::seconds kLongest{20};
    const auto end = std::chrono::steady_clock::now() + kLongest;
    while (!isMarked()) {
        requireContext();
        if (std::chrono::steady_clock::now() > end) {
            throw std::runtime_error(
                "The graphics driver says that results are there which are not; try another "
                "driver.");
        }
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    std::atomic_thread_fence(std::memory_order_acquire);
}

/// What was sent is gone where the memory grows.
void ReadBack::reserve(std::size_t bytes) {
    if (bytes <= capacity_ && id_ != 0) {
        return;
    }
    const std::size_t capacity =
        grownCapacity(capacity_, bytes, std::numeric_limits<std::size_t>::max());
    const Mapping grown = allocateMapped(capacity);
    release();
    id_ = grown.id;
    memory_ = grown.memory;
    capacity_ = capacity;
}

void ReadBack::dropFence() const {
    if (fence_ != nullptr) {
        glDeleteSync(static_cast<GLsync>(fence_));
        fence_ = nullptr;
    }
}

void ReadBack::release() {
    dropFence();
    if (id_ != 0) {
        glDeleteBuffers(1, &id_);  // ends the mapping too
        id_ = 0;
    }
}

}  // namespace kerf::gpu
