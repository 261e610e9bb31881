#pragma once

namespace kerf::test {

/// While it lives, counts the bytes of all OpenGL buffers that are made and deleted. One at a time,
/// with a context whose functions are loaded.
class BufferBytes {
  public:
    BufferBytes();
    ~BufferBytes();
    BufferBytes(const BufferBytes&) = delete;
    BufferBytes& operator=(const BufferBytes&) = delete;

    std::size_t now() const;      ///< of those that were made since, and are there
    std::size_t most() const;     ///< that there were at a time
    std::size_t largest() const;  ///< of one buffer
};

}  // namespace kerf::test
