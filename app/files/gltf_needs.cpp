#include "app/files/gltf_needs.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

namespace kerf::app {

namespace {

using Json = nlohmann::json;

// These change how the numbers of a surface are stored. assimp would read them as what they aren't.
constexpr std::array<std::string_view, 5> kUnreadable = {
    "KHR_draco_mesh_compression", "KHR_mesh_quantization", "EXT_meshopt_compression",
    "KHR_meshopt_compression", "EXT_mesh_gpu_instancing"};

/// The JSON of a GLB, empty for other files.
std::string jsonOfGlb(std::ifstream& in, std::uintmax_t size) {
    std::array<char, 20> head{};  // of the file, then of its first part: length and "JSON"
    in.read(head.data(), head.size());
    std::uint32_t length = 0;
    std::memcpy(&length, head.data() + 12, sizeof(length));
    if (!std::string_view(head.data(), head.size()).starts_with("glTF") || length > size) {
        return "";
    }
    std::string text(length, '\0');
    in.read(text.data(), length);
    return text;
}

/// The top of a file without the parts of it that can be long; no object where it isn't JSON.
Json topOf(const std::filesystem::path& file) {
    const Json::parser_callback_t onlyNeeds = [](int depth, Json::parse_event_t event, Json& at) {
        return depth != 1 || event != Json::parse_event_t::key || at == "extensionsRequired";
    };
    std::ifstream in(file, std::ios::binary);
    const std::string binary = jsonOfGlb(in, std::filesystem::file_size(file));
    if (!binary.empty()) {
        return Json::parse(binary, onlyNeeds, false);
    }
    in.clear();
    in.seekg(0);
    return Json::parse(in, onlyNeeds, false);
}

}  // namespace

std::string unreadableExtension(const std::filesystem::path& file) {
    const Json top = topOf(file);
    const auto needed = top.is_object() ? top.find("extensionsRequired") : top.end();
    if (needed == top.end() || !needed->is_array()) {
        return "";
    }
    for (const std::string_view name : kUnreadable) {
        if (std::ranges::find(*needed, Json(name)) != needed->end()) {
            return std::string(name);
        }
    }
    return "";
}

}  // namespace kerf::app
