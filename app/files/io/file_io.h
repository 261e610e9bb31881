#pragma once

#include "app/files/io/system_file.h"
#include "render/scene/image.h"

namespace kerf::app {

/// Why a path from a foreign file is invalid: a sentence; "" if valid.
std::string problemWithPath(std::string_view path);
/// A path for messages: of long ones, as foreign files may have, its beginning and its end.
std::string shownPath(const std::filesystem::path& path);
/// Whether a name from a file is inside a folder, by its text: not absolute, not leading out, and
/// not the folder itself. OutputFolder checks links.
bool isNameInside(std::string_view name);

/// Whether this path, links followed, is in a folder or below it. For missing files their existing
/// folders count. `folder` must be canonical.
bool leadsInside(const std::filesystem::path& folder, const std::filesystem::path& path);

/// The bytes of a regular file. Throws InputError if it is missing, not regular, not readable or
/// larger than `limit` bytes.
std::string readInputFile(const std::filesystem::path& file, std::uintmax_t limit);

/// A file that appears under its name only once it is complete: data goes into a hidden file of the
/// same folder, which commit() renames. Without commit() nothing is left. Valid links are followed;
/// devices and pipes are refused.
class AtomicFile {
  public:
    /// Throws OutputError, like all functions here.
    explicit AtomicFile(const std::filesystem::path& file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    /// Writes the bytes of one of Kerf's files, of any size.
    void writeAllOf(const std::filesystem::path& file);
    /// Replaces the first bytes, which were written.
    void writeAtStart(std::string_view bytes);
    void commit();

  private:
    void flush();

    std::filesystem::path file_;
    std::filesystem::path hidden_;
    std::string pending_;
    SystemFile out_;
    bool committed_ = false;
};

/// Whether a file is the hidden one of an AtomicFile of this name, by its name.
bool isUnfinished(std::string_view hidden, std::string_view name);

/// AtomicFile in one call.
void writeOutputFile(const std::filesystem::path& file, std::string_view bytes);

/// Pictures as PNG. A picture appears complete or not at all; they throw InputError and
/// OutputError.
render::Image readPicture(const std::filesystem::path& file);
void writePicture(const render::Image& picture, const std::filesystem::path& file);

/// Shortest decimal text that reads back as the same number, whatever the locale.
std::string formatNumber(double value);
std::string formatNumber(float value);

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

/// A safe file name from a foreign one: the part after the last slash, at most 200 bytes, with '_'
/// for control characters and before names that are empty or dots.
std::string plainName(const std::string& name);

/// A new file of that folder: STEM with an ending, and with -2, -3, ... if taken.
std::filesystem::path numberedFile(const std::filesystem::path& folder, const std::string& stem,
                                   const std::string& ending);

/// A new file of that folder: NAME-YYYYMMDD-HHMMSS with an ending, numbered if taken. NAME is
/// plainName(name).
std::filesystem::path freeFile(const std::filesystem::path& folder, const std::string& name,
                               const std::string& ending);

}  // namespace kerf::app
