#include "gpu/buffer.h"

#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>

#include <bit>
#include <cassert>

#include "gpu/context.h"
#include "gpu/gl_name.h"
#include "gpu/traffic.h"

namespace kerf::gpu {
namespace {

constexpr std::size_t kEmptyBytes = 16;

/// llvmpipe compiles a kernel anew where a buffer that it reads as texels has a power of two of
/// bytes: none has.
std::size_t withoutPowersOfTwo(std::size_t bytes) {
    constexpr std::size_t kMore = 16;
    return std::has_single_bit(bytes) ? bytes + std::min(bytes / 2, kMore) : bytes;
}

std::uint32_t allocate(std::size_t bytes) {
    forgetErrors();
    GLuint id = 0;
    glCreateBuffers(1, &id);
    glNamedBufferStorage(id, static_cast<GLsizeiptr>(withoutPowersOfTwo(bytes)), nullptr,
                         GL_DYNAMIC_STORAGE_BIT);
    try {
        throwIfOutOfMemory("a buffer", bytes);
    } catch (const OutOfMemory&) {
        glDeleteBuffers(1, &id);
        throw;
    }
    return id;
}

/// By uploads: where glClearNamedBufferSubData() cleared bytes, NVIDIA's 580.159 lost what was
/// written over them next (docs/notes/drivers.md).
void writeZeros(std::uint32_t id, std::size_t first, std::size_t last) {
    constexpr std::size_t kMostAtOnce = std::size_t{1} << 20;
    static const std::vector<std::byte> zeros(kMostAtOnce);
    traffic().bytesUp += first < last ? last - first : 0;
    for (; first < last; first += kMostAtOnce) {
        glNamedBufferSubData(id, static_cast<GLintptr>(first),
                             static_cast<GLsizeiptr>(std::min(last - first, kMostAtOnce)),
                             zeros.data());
    }
}

struct Texel {
    GLenum format;
    std::size_t bytes;
};

/// In the order of TexelFormat.
const Texel& texelOf(TexelFormat format) {
    static constexpr std::array<Texel, 5> texels{
        {{GL_R32UI, 4}, {GL_RG32UI, 8}, {GL_RGBA32UI, 16}, {GL_RG32F, 8}, {GL_RGBA32F, 16}}};
    return texels[static_cast<std::size_t>(format)];
}

void requireTexels(std::size_t count) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    if (count > static_cast<std::size_t>(limit)) {
        throw OutOfMemory(fmt::format(
            "A texture buffer of {} elements is needed, but this driver allows {} at most; use a "
            "smaller model.",
            count, limit));
    }
}

}  // namespace

Buffer::~Buffer() {
    if (texels_.texture != 0) {
        glDeleteTextures(1, &texels_.texture);
    }
    if (id_ != 0) {
        glDeleteBuffers(1, &id_);
    }
}

Buffer::Buffer(Buffer&& other) noexcept
    : readers_(other.readers_),
      id_(std::exchange(other.id_, 0)),
      size_(std::exchange(other.size_, 0)),
      capacity_(std::exchange(other.capacity_, 0)),
      texels_(std::exchange(other.texels_, {})) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(readers_, other.readers_);
    std::swap(id_, other.id_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
    std::swap(texels_, other.texels_);
    return *this;
}

void Buffer::resize(std::size_t bytes) {
    updateBarrier();
    reserve(std::max(bytes, kEmptyBytes), size_);
    writeZeros(id_, size_, bytes);
    size_ = bytes;
}

void Buffer::reserve(std::size_t bytes, std::size_t keep) {
    if (bytes <= capacity_) {
        return;
    }
    const std::size_t capacity = grownCapacity(
        capacity_, bytes, readers_ == Readers::texels ? texelLimit() : storageLimit());
    const std::uint32_t grown = allocate(capacity);
    if (keep > 0) {
        glCopyNamedBufferSubData(id_, grown, 0, 0, static_cast<GLsizeiptr>(keep));
    }
    if (id_ != 0) {
        glDeleteBuffers(1, &id_);
    }
    id_ = grown;
    capacity_ = capacity;
    texels_.buffer = 0;  // the old number may come back for another buffer
}

void Buffer::copyFrom(const Buffer& other) {
    updateBarrier();
    resize(other.size_);
    glCopyNamedBufferSubData(other.id_, id_, 0, 0, static_cast<GLsizeiptr>(other.size_));
}

void Buffer::clear() {
    updateBarrier();
    writeZeros(id_, 0, size_);
}

void Buffer::bindStorage(std::uint32_t binding) const {
    assert(id_ != 0 && "a buffer needs storage before it is bound");
    assert(readers_ == Readers::storage && "a buffer for texels is bound by parts");
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id_);
}

std::size_t Buffer::storagePart(std::size_t elementBytes) {
    GLint alignment = 1;
    glGetIntegerv(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &alignment);
    const std::size_t aligned = elementBytes * static_cast<std::size_t>(alignment);
    return storageLimit() / aligned * static_cast<std::size_t>(alignment);
}

void Buffer::bindStorageRange(std::uint32_t binding, std::size_t offset, std::size_t bytes) const {
    assert(id_ != 0 && "a buffer needs storage before it is bound");
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, id_, static_cast<GLintptr>(offset),
                      static_cast<GLsizeiptr>(bytes));
}

void Buffer::bindTexels(std::uint32_t unit, TexelFormat format) const {
    showTexels(format);
    glBindTextureUnit(unit, texels_.texture);
}

void Buffer::bindImage(std::uint32_t unit, TexelFormat format) const {
    showTexels(format);
    glBindImageTexture(unit, texels_.texture, 0, GL_FALSE, 0, GL_READ_ONLY, texelOf(format).format);
}

void Buffer::showTexels(TexelFormat format) const {
    assert(id_ != 0 && "a buffer needs storage before it is bound");
    if (texels_.buffer == id_ && texels_.format == format) {
        return;
    }
    const Texel& texel = texelOf(format);
    requireTexels(capacity_ / texel.bytes);
    if (texels_.texture == 0) {
        glCreateTextures(GL_TEXTURE_BUFFER, 1, &texels_.texture);
    }
    glTextureBuffer(texels_.texture, texel.format, id_);
    texels_.buffer = id_;
    texels_.format = format;
}

void Buffer::assignBytes(std::span<const std::byte> data) {
    reserve(std::max(data.size(), kEmptyBytes), 0);
    size_ = data.empty() ? kEmptyBytes : data.size();
    if (data.empty()) {
        clear();
    } else {
        writeBytes(0, data);
    }
}

void Buffer::writeBytes(std::size_t offset, std::span<const std::byte> data) {
    assert(offset + data.size() <= size_ && "write beyond the size in use");
    if (data.empty()) {
        return;
    }
    updateBarrier();
    traffic().bytesUp += data.size();
    glNamedBufferSubData(id_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()),
                         data.data());
}

void Buffer::readBytes(std::size_t offset, std::span<std::byte> out) const {
    assert(offset + out.size() <= size_ && "read beyond the size in use");
    if (out.empty()) {
        return;
    }
    updateBarrier();
    ++traffic().reads;
    traffic().bytesDown += out.size();
    glGetNamedBufferSubData(id_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(out.size()),
                            out.data());
    requireContext();
}

}  // namespace kerf::gpu
