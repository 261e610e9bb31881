#include "app/files/io/data_page.h"

#include <nlohmann/json.hpp>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "gpu/data_path.h"

namespace kerf::app {

namespace {

constexpr std::uintmax_t kMaxPageBytes = 16u << 20;
constexpr std::string_view kBeforeData = "<script id=\"data\" type=\"application/json\">";

/// JSON inside a script, where nothing may look like the script's end.
std::string scriptText(const nlohmann::ordered_json& json) {
    std::string text;
    for (const char c :
         json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
        text += c == '<' ? "\\u003c" : std::string(1, c);
    }
    return text;
}

}  // namespace

std::string dataPage(const std::string& asset, const nlohmann::ordered_json& data) {
    std::string page = readInputFile(gpu::dataPath("assets/report/" + asset), kMaxPageBytes);
    const std::size_t before = page.find(kBeforeData);
    const std::size_t end = page.find("</script>", before);
    if (before == std::string::npos || end == std::string::npos) {
        throw InputError("assets/report/" + asset + ": the place of the data is missing.");
    }
    const std::size_t begin = before + kBeforeData.size();
    return page.replace(begin, end - begin, scriptText(data));
}

}  // namespace kerf::app
