#include "app/files/io/file_cache.h"

#include <fstream>

#include "app/files/io/encodings.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"

namespace kerf::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigest = 64;  // digits of the SHA-256 in front of the bytes

}  // namespace

void FileCache::keep(const std::string& key, const std::vector<std::byte>& bytes) const {
    std::error_code error;
    if (folder_.empty() || bytes.size() > budget_) {
        return;
    }
    fs::create_directories(folder_, error);
    try {
        AtomicFile file(folder_ / key);
        file.write(sha256Of(bytes));
        file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        file.commit();
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
    if (error || size < kDigest || size > budget_ || !stream) {
        return std::nullopt;
    }
    std::string digest(kDigest, ' ');
    std::vector<std::byte> bytes(size - kDigest);
    stream.read(digest.data(), kDigest);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream || sha256Of(bytes) != digest) {
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
