#pragma once

#include <stdexcept>

namespace kerf::gpu {

/// Out of GPU memory: the message names the requested bytes and the limit.
class OutOfMemory : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The element format of a buffer that shaders read through a texture unit.
enum class TexelFormat { uint32, uint32x2, uint32x4, float32x2, float32x4 };

/// An OpenGL buffer object (move only) with a size in use and a capacity with headroom.
class Buffer {
  public:
    /// How it is read: as shader storage, which some drivers limit (llvmpipe: 128 MiB), or as
    /// texels only, limited by the driver's texture buffers.
    enum class Readers { storage, texels };

    explicit Buffer(Readers readers = Readers::storage) : readers_(readers) {}
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    /// Sets the size in use, and grows the capacity if needed (by half again; keeps the content,
    /// copied on the GPU); new bytes are zero. Throws OutOfMemory, the buffer then unchanged.
    void resize(std::size_t bytes);

    /// resize(data.size_bytes()) and write. An empty span leaves a buffer of 16 zero bytes, since
    /// binding a buffer without storage is an error.
    template <class T>
    void assign(std::span<const T> data) {
        assignBytes(std::as_bytes(data));
    }
    template <class T>
    void assign(const std::vector<T>& data) {
        assign(std::span<const T>(data));
    }

    /// Writes elements from index `first` on; they must lie inside the size in use.
    template <class T>
    void write(std::size_t first, std::span<const T> data) {
        writeBytes(first * sizeof(T), std::as_bytes(data));
    }

    /// Reads `count` elements from index `first` on (waits for the GPU).
    template <class T>
    std::vector<T> read(std::size_t first, std::size_t count) const {
        std::vector<T> out(count);
        readBytes(first * sizeof(T), std::as_writable_bytes(std::span<T>(out)));
        return out;
    }

    /// Takes the size in use and the content of `other`, copied on the GPU. Throws OutOfMemory.
    void copyFrom(const Buffer& other);
    /// Fills the size in use with zero bits.
    void clear();

    /// Binds as shader storage to `binding`. A buffer for texels is bound by parts instead.
    void bindStorage(std::uint32_t binding) const;
    /// Binds it as shader storage to `binding` part by part, each within the driver's limit, and
    /// calls visit(first, count) for the elements of `elementBytes` of that part: a shader sees
    /// element `first` as its first.
    template <class Visit>
    void bindStorageParts(std::uint32_t binding, std::size_t elementBytes, Visit&& visit) const {
        const std::size_t count = size_ / elementBytes;
        const std::size_t most = storagePart(elementBytes);
        for (std::size_t first = 0; first < count; first += most) {
            const std::size_t part = std::min(most, count - first);
            bindStorageRange(binding, first * elementBytes, part * elementBytes);
            visit(first, part);
        }
    }
    /// Binds as a texture buffer to `unit`, for kernels that only read it, here and there: Mesa's
    /// llvmpipe fetches a texel about four times as fast as it reads four words of storage, other
    /// drivers as fast. Throws OutOfMemory if the driver's texture buffers are too small.
    void bindTexels(std::uint32_t unit, TexelFormat format) const;

    /// Binds the texels as an image to read from, for kernels that write it as storage too.
    void bindImage(std::uint32_t unit, TexelFormat format) const;

    std::uint32_t id() const { return id_; }
    std::size_t size() const { return size_; }          ///< [bytes]
    std::size_t capacity() const { return capacity_; }  ///< [bytes]

  private:
    /// Makes room for `bytes`; the first `keep` bytes survive.
    void reserve(std::size_t bytes, std::size_t keep);
    void showTexels(TexelFormat format) const;
    /// The elements of a part that is bound as storage.
    static std::size_t storagePart(std::size_t elementBytes);
    void bindStorageRange(std::uint32_t binding, std::size_t offset, std::size_t bytes) const;
    void assignBytes(std::span<const std::byte> data);
    void writeBytes(std::size_t offset, std::span<const std::byte> data);
    void readBytes(std::size_t offset, std::span<std::byte> out) const;

    Readers readers_;
    std::uint32_t id_ = 0;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;

    /// A view for texture units, made on first use.
    struct Texels {
        std::uint32_t texture = 0;
        std::uint32_t buffer = 0;  ///< whose storage it shows
        TexelFormat format = TexelFormat::uint32;
    };
    mutable Texels texels_;
};

}  // namespace kerf::gpu
