#include "app/files/io/base64.h"

#include <nettle/base64.h>

#include <cstdint>

#include "app/files/io/errors.h"

namespace kerf::app {

std::string base64(std::string_view bytes) {
    std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
    base64_encode_raw(text.data(), bytes.size(),
                      reinterpret_cast<const std::uint8_t*>(bytes.data()));
    return text;
}

std::string bytesOfBase64(std::string_view text) {
    std::string bytes(BASE64_DECODE_LENGTH(text.size()), '\0');
    base64_decode_ctx context;
    base64_decode_init(&context);
    std::size_t length = bytes.size();
    if (base64_decode_update(&context, &length, reinterpret_cast<std::uint8_t*>(bytes.data()),
                             text.size(), text.data()) == 0 ||
        base64_decode_final(&context) == 0) {
        throw InputError("it has data that is no base64");
    }
    bytes.resize(length);
    return bytes;
}

}  // namespace kerf::app
