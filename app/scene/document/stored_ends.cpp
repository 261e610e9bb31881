#include "app/scene/document/stored_ends.h"

#include <stdexcept>

#include "app/files/io/encodings.h"
#include "app/files/io/errors.h"
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

}  // namespace kerf::app
