#include "gpu/numbers_table.h"

#include <glad/gl.h>

#include "gpu/gl_name.h"

namespace kerf::gpu {
namespace {

constexpr GLuint kBinding = 0;         // as shaders/sim/base/numbers.glsl has it
constexpr std::size_t kPlaces = 1024;  // then a new buffer begins

std::size_t strideOfParts() {
    GLint alignment = 1;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    const auto step = static_cast<std::size_t>(alignment);
    return (sizeof(DispatchNumbers) + step - 1) / step * step;
}

}  // namespace

NumbersTable::~NumbersTable() {
    glDeleteBuffers(1, &buffer_);
}

// What dispatches on their way still read of the buffer before lives as long as they do.
void NumbersTable::begin() {
    glDeleteBuffers(1, &buffer_);
    places_.clear();
    stride_ = strideOfParts();
    forgetErrors();
    glCreateBuffers(1, &buffer_);
    glNamedBufferStorage(buffer_, static_cast<GLsizeiptr>(kPlaces * stride_), nullptr,
                         GL_DYNAMIC_STORAGE_BIT);
    throwIfOutOfMemory("the numbers of a kernel", kPlaces * stride_);
}

void NumbersTable::choose(const DispatchNumbers& numbers) {
    const auto known = places_.find(numbers);
    if (known != places_.end()) {
        chosen_ = known->second;
        return;
    }
    if (buffer_ == 0 || places_.size() == kPlaces) {
        begin();
    }
    chosen_ = places_.size() * stride_;
    glNamedBufferSubData(buffer_, static_cast<GLintptr>(chosen_), sizeof(DispatchNumbers),
                         numbers.data());
    places_.emplace(numbers, chosen_);
}

void NumbersTable::bind() const {
    if (buffer_ != 0) {
        glBindBufferRange(GL_UNIFORM_BUFFER, kBinding, buffer_, static_cast<GLintptr>(chosen_),
                          sizeof(DispatchNumbers));
    }
}

}  // namespace kerf::gpu
