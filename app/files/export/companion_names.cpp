#include "app/files/export/companion_names.h"

#include <cctype>
#include <fstream>

#include "app/files/io/file_io.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLetters = 100;
constexpr std::size_t kMarkWithin = 8;  // first bytes: "# Kerf" in texts

bool isPlain(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
}

/// No folders, nothing hidden, and only letters that need no escape in a URI: VTK and Open3D look
/// for a file of the name "tile%20one.png".
std::string safeName(const std::string& wanted) {
    std::string name = wanted.substr(wanted.find_last_of("/\\") + 1);
    std::ranges::replace_if(name, std::not_fn(isPlain), '_');
    if (name.starts_with('.') || name.empty()) {
        name.insert(0, "_");
    }
    return name.size() > kMostLetters ? name.substr(name.size() - kMostLetters) : name;
}

std::string numbered(const std::string& name, int number) {
    return fs::path(name).stem().string() + "-" + std::to_string(number) +
           fs::path(name).extension().string();
}

bool isOfKerf(const fs::path& file) {
    std::string head(kMarkWithin, ' ');
    std::ifstream(file, std::ios::binary).read(head.data(), kMarkWithin);
    return head.find(kCompanionMark) != std::string::npos;
}

}  // namespace

std::string CompanionNames::nameFor(const std::string& wanted, std::string_view bytes) const {
    const std::string safe = safeName(wanted);
    std::string name = safe;
    for (int number = 2; !mayBecome(name, bytes); ++number) {
        name = numbered(safe, number);
    }
    return name;
}

bool CompanionNames::isThere(const std::string& name, std::string_view bytes) const {
    std::error_code error;
    const fs::path file = folder_ / name;
    return fs::is_regular_file(file, error) && fs::file_size(file, error) == bytes.size() &&
           !error && readInputFile(file, bytes.size()) == bytes;
}

bool CompanionNames::mayBecome(const std::string& name, std::string_view bytes) const {
    std::error_code error;
    const fs::file_status status = fs::symlink_status(folder_ / name, error);
    return !fs::exists(status) || isThere(name, bytes) ||
           (fs::is_regular_file(status) && isOfKerf(folder_ / name));
}

}  // namespace kerf::app
