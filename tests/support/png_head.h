#pragma once

namespace kerf::test {

/// A PNG of grey levels whose head says how large it is, with no pixels behind it.
inline std::string pngHead(std::uint32_t width, std::uint32_t height) {
    constexpr std::size_t kChecksum = 4;  // that nobody looks at
    std::string bytes = "\x89PNG\r\n\x1a\n";
    bytes.append("\0\0\0\x0dIHDR", 8);
    for (const std::uint32_t side : {width, height}) {
        for (const int shift : {24, 16, 8, 0}) {
            bytes += static_cast<char>(side >> shift & 0xFFU);
        }
    }
    bytes.append("\x08\0\0\0\0", 5).append(kChecksum, '\0');
    return bytes.append("\0\0\0\0IDAT", 8).append(kChecksum, '\0');
}

}  // namespace kerf::test
