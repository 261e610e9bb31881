#include "app/files/io/free_file.h"

#include <spdlog/fmt/chrono.h>

#include <ctime>

#include "sim/base/text.h"

namespace kerf::app {

std::string plainName(const std::string& name) {
    constexpr std::size_t kMost = 200;
    std::string plain = beginningOf(name.substr(name.find_last_of('/') + 1), kMost);
    std::ranges::replace_if(
        plain, [](unsigned char c) { return c < ' ' || c == 0x7f; }, '_');
    return plain.empty() || plain == "." || plain == ".." ? "_" + plain : plain;
}

std::filesystem::path numberedFile(const std::filesystem::path& folder, const std::string& stem,
                                   const std::string& ending) {
    std::filesystem::path file = folder / (stem + ending);
    std::error_code unknown;  // a folder that can't be looked into: writing will say so
    for (int n = 2; std::filesystem::exists(file, unknown); ++n) {
        std::string numbered = stem;
        file = folder / numbered.append("-").append(std::to_string(n)).append(ending);
    }
    return std::filesystem::absolute(file).lexically_normal();
}

std::filesystem::path freeFile(const std::filesystem::path& folder, const std::string& name,
                               const std::string& ending) {
    const std::tm now = fmt::localtime(std::time(nullptr));
    return numberedFile(folder, fmt::format("{}-{:%Y%m%d-%H%M%S}", plainName(name), now), ending);
}

}  // namespace kerf::app
