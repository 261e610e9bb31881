#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/files/io/system_file.h"
#include "render/scene/image.h"

namespace kerf::app {

/// Why no file can have this path, which stands in a file of somebody else: a sentence; "" where
/// one can.
std::string problemWithPath(std::string_view path);
/// A path as a sentence names it: where it is long, as files of others may make it, its beginning
/// and its end.
std::string shownPath(const std::filesystem::path& path);
/// Whether a name that stands in a file means a file inside of a folder, by its letters alone: not
/// absolute, without a way out, and not the folder itself. Links are for OutputFolder to see.
bool isNameInside(std::string_view name);

/// Whether what is there under this path, links followed, lies in a folder or below it. Of what is
/// not there yet the folders on its way count. `folder` must be canonical.
bool leadsInside(const std::filesystem::path& folder, const std::filesystem::path& path);

/// The bytes of a regular file. Throws InputError where it is missing, no regular file, not
/// readable or larger than `limit` bytes.
std::string readInputFile(const std::filesystem::path& file, std::uintmax_t limit);

/// A file that appears under its name only once it is complete: what is written goes into a hidden
/// file of the same folder, which commit() renames. Without commit() nothing is left. A link that
/// leads somewhere is followed; a device or a pipe is refused.
class AtomicFile {
  public:
    /// Throws OutputError, as all functions here.
    explicit AtomicFile(const std::filesystem::path& file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    /// The bytes of a file of ours, of any size.
    void writeAllOf(const std::filesystem::path& file);
    void commit();

  private:
    void flush();

    std::filesystem::path file_;
    std::filesystem::path hidden_;
    std::string pending_;
    SystemFile out_;
    bool committed_ = false;
};

/// Whether a file is the hidden one of an AtomicFile of this name, by its letters alone.
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

}  // namespace kerf::app
