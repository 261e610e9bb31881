#include "app/import/xml_file.h"

#include "app/files/io/errors.h"

namespace kerf::app {

void loadXml(std::string_view bytes, pugi::xml_document& document) {
    const pugi::xml_parse_result result = document.load_buffer(
        bytes.data(), bytes.size(), pugi::parse_default | pugi::parse_trim_pcdata);
    if (!result) {
        const std::string_view before = bytes.substr(0, std::size_t(result.offset));
        const std::string line = std::to_string(1 + std::ranges::count(before, '\n'));
        // In others the place counts characters, not bytes.
        const bool inBytes = result.encoding == pugi::encoding_utf8;
        throw InputError((inBytes ? "line " + line + ": " : "") + "its XML is broken (" +
                         result.description() + ")");
    }
}

}  // namespace kerf::app
