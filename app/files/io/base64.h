#pragma once

#include <string>
#include <string_view>

namespace kerf::app {

/// Bytes as letters, four for three, padded by '=' (RFC 4648).
std::string base64(std::string_view bytes);
/// Decodes such letters; ignores blanks. Throws InputError.
std::string bytesOfBase64(std::string_view text);

}  // namespace kerf::app
