#pragma once

#include <cstdint>
#include <string>

namespace kerf::test {

/// A number of four bytes, the highest first.
inline std::string bigEndian(std::uint32_t number) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0}) {
        bytes += static_cast<char>(number >> shift & 0xFFU);
    }
    return bytes;
}

/// The checksum that ends each part of a PNG.
inline std::uint32_t pngChecksum(const std::string& bytes) {
    std::uint32_t sum = ~0U;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            sum = sum >> 1 ^ (sum % 2 != 0 ? 0xEDB88320U : 0U);
        }
    }
    return ~sum;
}

/// A PNG whose head says how large it is, with nothing behind it.
inline std::string pngHead(std::uint32_t width, std::uint32_t height) {
    const std::string part =
        "IHDR" + bigEndian(width) + bigEndian(height) + std::string("\x08\x06\0\0\0", 5);
    return "\x89PNG\r\n\x1a\n" + bigEndian(13) + part + bigEndian(pngChecksum(part));
}

}  // namespace kerf::test
