#include "app/files/io/file_cache.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <utility>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"

namespace kerf::app {

namespace fs = std::filesystem;

void FileCache::keep(const std::string& key, const std::vector<std::byte>& bytes) const {
    std::error_code error;
    if (folder_.empty() || bytes.size() > budget_) {
        return;
    }
    fs::create_directories(folder_, error);
    try {
        writeOutputFile(folder_ / key, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } catch (const OutputError&) {
        return;
    }
    keepToBudget();
}

std::optional<std::vector<std::byte>> FileCache::find(const std::string& key) const {
    const fs::path file = folder_ / key;
    std::error_code error;
    const std::uintmax_t size = folder_.empty() ? 0 : fs::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    if (error || size == 0 || size > budget_ || !stream) {
        return std::nullopt;
    }
    std::vector<std::byte> bytes(size);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!stream) {
        return std::nullopt;
    }
    fs::last_write_time(file, fs::file_time_type::clock::now(), error);
    return bytes;
}

void FileCache::keepToBudget() const {
    std::error_code error;
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::uintmax_t sum = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        sum += entry.file_size(error);
        files.emplace_back(entry.last_write_time(error), entry.path());
    }
    std::ranges::sort(files);
    for (const auto& [time, file] : files) {
        if (sum <= budget_) {
            return;
        }
        sum -= fs::file_size(file, error);
        fs::remove(file, error);
    }
}

}  // namespace kerf::app
