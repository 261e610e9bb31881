#include "tests/support/fuzz/packed_files.h"

#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace {

constexpr char kFileEnd = '\x1c';  // ASCII's file separator

}  // namespace

std::string packed(const std::vector<std::string>& files) {
    std::string text;
    for (std::size_t i = 0; i < files.size(); ++i) {
        text.append(i == 0 ? 0 : 1, kFileEnd).append(files[i]);
    }
    return text;
}

void unpack(const std::string& text, const std::filesystem::path& folder,
            const std::vector<std::string>& names) {
    std::size_t from = 0;
    for (const std::string& name : names) {
        if (from > text.size()) {
            std::filesystem::remove(folder / name);
            continue;
        }
        const std::size_t end = std::min(text.find(kFileEnd, from), text.size());
        writeText(folder / name, std::string_view(text).substr(from, end - from));
        from = end + 1;
    }
}

}  // namespace kerf::test
