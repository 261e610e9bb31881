#include "tests/support/buffer_bytes.h"

#include <glad/gl.h>

namespace kerf::test {

namespace {

struct Counts {
    std::map<GLuint, std::size_t> ofBuffer;
    std::size_t now = 0;
    std::size_t most = 0;
    std::size_t largest = 0;
};

Counts counts;
PFNGLNAMEDBUFFERSTORAGEPROC driversStorage = nullptr;
PFNGLDELETEBUFFERSPROC driversDelete = nullptr;

void GLAD_API_PTR countStorage(GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
    driversStorage(buffer, size, data, flags);
    const auto bytes = static_cast<std::size_t>(size);
    counts.ofBuffer[buffer] = bytes;
    counts.now += bytes;
    counts.most = std::max(counts.most, counts.now);
    counts.largest = std::max(counts.largest, bytes);
}

void GLAD_API_PTR countDelete(GLsizei count, const GLuint* buffers) {
    driversDelete(count, buffers);
    for (GLsizei i = 0; i < count; ++i) {
        if (const auto found = counts.ofBuffer.find(buffers[i]); found != counts.ofBuffer.end()) {
            counts.now -= found->second;
            counts.ofBuffer.erase(found);
        }
    }
}

}  // namespace

BufferBytes::BufferBytes() {
    counts = {};
    driversStorage = glad_glNamedBufferStorage;
    driversDelete = glad_glDeleteBuffers;
    glad_glNamedBufferStorage = countStorage;
    glad_glDeleteBuffers = countDelete;
}

BufferBytes::~BufferBytes() {
    glad_glNamedBufferStorage = driversStorage;
    glad_glDeleteBuffers = driversDelete;
}

std::size_t BufferBytes::now() const {
    return counts.now;
}

std::size_t BufferBytes::most() const {
    return counts.most;
}

std::size_t BufferBytes::largest() const {
    return counts.largest;
}

}  // namespace kerf::test
