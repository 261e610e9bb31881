#include "app/scene/document/stored_ends.h"

#include <fstream>
#include <stdexcept>

#include "app/files/io/encodings.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "gpu/data_path.h"
#include "sim/base/byte_archive.h"
#include "sim/run/state_hash.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

/// Changes with each build: only the one that wrote a moment surely reads it.
void addProgram(StateHash& hash) {
    const fs::path program = "/proc/self/exe";
    std::error_code error;
    hash.addExactly(static_cast<double>(fs::file_size(program, error)));
    const auto time = fs::last_write_time(program, error).time_since_epoch().count();
    hash.add(std::to_string(time));
}

}  // namespace

std::string StoredEnds::keyOf(const fs::path& session) const {
    StateHash maker;
    maker.add(driver_);
    addProgram(maker);
    return sha256OfFile(session) + "-" + maker.hexadecimal();
}

void StoredEnds::keep(const fs::path& session, const StoredEnd& end) const {
    ByteWriter to;
    to(end);
    cache_.keep(keyOf(session), to.bytes);
}

std::optional<StoredEnd> StoredEnds::of(const fs::path& session) const {
    try {
        const auto bytes = cache_.find(keyOf(session));
        if (!bytes) {
            return std::nullopt;
        }
        ByteReader from(*bytes);
        StoredEnd end;
        from(end);
        return end;
    } catch (const InputError&) {
        return std::nullopt;
    } catch (const std::out_of_range&) {
        return std::nullopt;
    }
}

fs::path defaultStoredEnds() {
    return gpu::userPath("XDG_CACHE_HOME", ".cache", "ends");
}

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
