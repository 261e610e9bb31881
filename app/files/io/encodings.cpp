#include "app/files/io/encodings.h"

#include <nettle/base64.h>
#include <nettle/sha2.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"

namespace kerf::app {

namespace {

constexpr std::size_t kReadBlock = 1 << 16;

std::string finish(sha256_ctx& context) {
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context, digest.size(), digest.data());
    std::string text;
    for (const std::uint8_t byte : digest) {
        constexpr std::string_view digits = "0123456789abcdef";
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

/// The text as UTF-8 that XML can hold: U+FFFD stands for what names of files may have besides.
std::string asUtf8(const std::string& text) {
    using Json = nlohmann::json;
    std::string valid =
        Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
    for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
        for (std::size_t at = 0; (at = valid.find(none, at)) != std::string::npos;) {
            valid.replace(at, none.size(), "\xEF\xBF\xBD");
        }
    }
    return valid;
}

}  // namespace

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

std::string sha256OfFile(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!std::filesystem::is_regular_file(file) || !stream) {
        throw InputError(
            shownPath(file) +
            ": there is no such file, or it can't be read; check its name and rights.");
    }
    sha256_ctx context;
    sha256_init(&context);
    std::vector<std::uint8_t> block(kReadBlock);
    while (stream) {
        stream.read(reinterpret_cast<char*>(block.data()),
                    static_cast<std::streamsize>(block.size()));
        sha256_update(&context, static_cast<std::size_t>(stream.gcount()), block.data());
    }
    return finish(context);
}

std::string sha256Of(std::span<const std::byte> bytes) {
    sha256_ctx context;
    sha256_init(&context);
    sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    return finish(context);
}

std::string xmlText(const std::string& text) {
    std::string out;
    for (const char c : asUtf8(text)) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

}  // namespace kerf::app
