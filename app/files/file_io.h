#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/files/system_file.h"
#include "render/scene/image.h"

namespace kerf::app {

/// The bytes of a regular file. Throws InputError where it is missing, no regular file, not
/// readable or larger than `limit` bytes.
std::string readInputFile(const std::filesystem::path& file, std::uintmax_t limit);

/// A file that appears under its name only once it is complete: what is written goes into a hidden
/// file of the same folder, which commit() renames. Without commit() nothing is left. A link is
/// followed; a device or a pipe is refused.
class AtomicFile {
  public:
    /// Throws OutputError, as all functions here.
    explicit AtomicFile(const std::filesystem::path& file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    void commit();

  private:
    void flush();

    std::filesystem::path file_;
    std::filesystem::path hidden_;
    std::string pending_;
    SystemFile out_;
    bool committed_ = false;
};

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
