#pragma once

#include "app/files/io/file_io.h"
#include "app/files/io/system_file.h"
#include "app/files/jobs/child_process.h"
#include "render/scene/image.h"

namespace kerf::app {

/// Formats of films.
enum class FilmFormat : std::uint8_t { mp4, webm, gif };

struct FilmFormatInfo {
    FilmFormat format = FilmFormat::mp4;
    std::string_view extension;  ///< ".mp4"
    std::string_view name;       ///< as people call it
    int rate = 30;               ///< default frames per second
    bool evenSides = true;       ///< it needs even numbers of pixels
};
/// All formats, in the order of the dialog.
std::span<const FilmFormatInfo> filmFormats();
/// The format of a file's extension; null for any other extension.
const FilmFormatInfo* filmFormatOf(const std::filesystem::path& file);
/// The extensions as a sentence lists them: ".mp4, .webm or .gif".
std::string filmEndings();

/// Encodes a film by the program ffmpeg, as a child process. The film appears under its name only
/// once it is complete.
class FilmEncoder {
  public:
    /// Begins the film `file` with `rate` pictures a second of width x height pixels; its extension
    /// must be one of filmFormats(). ffmpeg writes to `unfinished` first, and to files whose names
    /// begin like it, which are removed with this object. Throws OutputError if ffmpeg is missing
    /// or the film can't be written.
    FilmEncoder(const std::filesystem::path& file, std::filesystem::path unfinished, int width,
                int height, int rate);
    ~FilmEncoder();
    FilmEncoder(const FilmEncoder&) = delete;
    FilmEncoder& operator=(const FilmEncoder&) = delete;

    /// Adds a frame of the size of the film. Throws OutputError, like finish().
    void add(const render::Image& picture);
    /// Completes the film.
    void finish();

  private:
    void start(const std::vector<std::string>& words);
    void requireDone();
    void reduceColors();
    std::filesystem::path colors() const;
    std::filesystem::path inColors() const;
    [[noreturn]] void complain();

    std::filesystem::path name_;
    FilmFormat format_;
    AtomicFile file_;
    std::filesystem::path unfinished_;
    Descriptor log_;
    Pipe pictures_;
    std::optional<ChildProcess> child_;  ///< none once it has ended
};

}  // namespace kerf::app
