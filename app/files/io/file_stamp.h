#pragma once

namespace kerf::app {

/// What a version of a file is known by.
struct FileStamp {
    std::filesystem::file_time_type written;
    std::uintmax_t bytes = 0;
    bool operator==(const FileStamp&) const = default;
};

/// None if it is not there.
inline std::optional<FileStamp> stampOf(const std::filesystem::path& file) {
    std::error_code timeError;
    std::error_code sizeError;
    const FileStamp stamp{std::filesystem::last_write_time(file, timeError),
                          std::filesystem::file_size(file, sizeError)};
    return timeError || sizeError ? std::nullopt : std::optional(stamp);
}

}  // namespace kerf::app
