#pragma once

namespace kerf::app {

/// Bytes as letters, four for three, padded by '=' (RFC 4648).
std::string base64(std::string_view bytes);
/// Decodes such letters; ignores blanks. Throws InputError.
std::string bytesOfBase64(std::string_view text);

/// SHA-256 (FIPS 180-4) of a file's content as 64 lower-case hexadecimal digits. Throws InputError
/// if it can't be read.
std::string sha256OfFile(const std::filesystem::path& file);
/// The same of bytes in memory.
std::string sha256Of(std::span<const std::byte> bytes);

/// Text as XML holds it. Control characters have no place there.
std::string xmlText(const std::string& text);

}  // namespace kerf::app
