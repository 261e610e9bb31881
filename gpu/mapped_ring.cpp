#include "gpu/mapped_ring.h"

#include <glad/gl.h>

#include <cassert>
#include <stdexcept>

#include "gpu/buffer.h"
#include "gpu/context_loss.h"
#include "gpu/gl_check.h"
#include "gpu/traffic.h"

namespace kerf::gpu {
namespace {

constexpr GLbitfield kAccess = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;

/// The least distance of two slots of `bytes` that can be bound each by itself.
std::size_t strideOf(std::size_t bytes) {
    GLint alignment = 1;
    glGetIntegerv(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &alignment);
    const auto step = static_cast<std::size_t>(alignment);
    return (bytes + step - 1) / step * step;
}

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
        glClearNamedBufferData(made.id, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
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

}  // namespace

MappedRing::~MappedRing() {
    release();
}

void MappedRing::reserve(std::size_t bytes) {
    if (bytes <= capacity_) {
        return;
    }
    const std::size_t capacity = grownCapacity(capacity_, bytes, storageLimit());
    const std::size_t stride = strideOf(capacity);
    const Mapping grown = allocateMapped(kSlots * stride);
    release();
    id_ = grown.id;
    memory_ = grown.memory;
    capacity_ = capacity;
    stride_ = stride;
}

int MappedRing::bindNext(std::uint32_t binding) {
    assert(id_ != 0 && "a ring needs room before it is bound");
    slot_ = (slot_ + 1) % kSlots;
    dropFence(slot_);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, id_,
                      static_cast<GLintptr>(slot_ * stride_), static_cast<GLsizeiptr>(capacity_));
    return slot_;
}

void MappedRing::fence() {
    dropFence(slot_);
    barrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    fences_[slot_] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (fences_[slot_] == nullptr) {
        throw std::runtime_error("The graphics driver gives no fence to wait for.");
    }
    glFlush();  // so that the GPU works while the CPU does something else
}

const std::byte* MappedRing::awaited(int slot, std::size_t bytes) const {
    assert(bytes <= capacity_ && "read beyond the slot");
    assert(fences_[slot] != nullptr && "only what was fenced can be waited for");
    ++traffic().waits;
    traffic().bytesDown += bytes;
    waitFor(static_cast<GLsync>(fences_[slot]));
    return memory_ + slot * stride_;
}

void MappedRing::dropFence(int slot) {
    if (fences_[slot] != nullptr) {
        glDeleteSync(static_cast<GLsync>(fences_[slot]));
        fences_[slot] = nullptr;
    }
}

void MappedRing::release() {
    for (int slot = 0; slot < kSlots; ++slot) {
        dropFence(slot);
    }
    if (id_ != 0) {
        glDeleteBuffers(1, &id_);  // ends the mapping too
    }
}

}  // namespace kerf::gpu
