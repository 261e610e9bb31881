#include "bench/lab/experiment/shader_inventory.h"

#include <regex>
#include <sstream>

#include "app/files/io/file_io.h"
#include "shaders/shared/body_records.h"

namespace kerf::app {

namespace {

constexpr std::uintmax_t kMostBytes = 1 << 20;

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t");
    return first == std::string::npos
               ? ""
               : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The statements of a header, each with the comment behind it, on one line each.
std::vector<std::string> statements(const std::string& header) {
    std::vector<std::string> lines;
    std::istringstream in(header);
    bool open = false;  // the statement goes on in the next line
    for (std::string line; std::getline(in, line);) {
        if (open) {
            lines.back() += " " + trimmed(line);
        } else {
            lines.push_back(trimmed(line));
        }
        open =
            lines.back().starts_with("SHARED_CONST") && lines.back().find(';') == std::string::npos;
    }
    return lines;
}

std::vector<ShaderBuffer> readBuffers(const std::filesystem::path& header) {
    static const std::regex kBinding(
        R"(SHARED_CONST uint k(\w+)Binding = (\d+)u;\s*//\s*([^:]*): (.*))");
    std::vector<ShaderBuffer> buffers;
    std::smatch match;
    for (const std::string& line : statements(readInputFile(header, kMostBytes))) {
        if (std::regex_match(line, match, kBinding)) {
            buffers.push_back({std::stoi(match[2]), match[1], match[3], match[4]});
        }
    }
    return buffers;
}

int countKernels(const std::filesystem::path& folder) {
    int kernels = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        kernels += entry.path().extension() == ".comp" ? 1 : 0;
    }
    return kernels;
}

}  // namespace

ShaderInventory readShaderInventory(const std::filesystem::path& root) {
    return {readBuffers(root / "shared/bindings.h"), countKernels(root / "sim"),
            static_cast<int>(shared::kGroupSize)};
}

}  // namespace kerf::app
