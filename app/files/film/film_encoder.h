#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/files/film/film_formats.h"
#include "app/files/io/descriptor.h"
#include "app/files/io/file_io.h"
#include "render/scene/image.h"

namespace kerf::app {

/// Makes a film of pictures by the program ffmpeg, which runs as a child of this one. The film
/// appears under its name only once it is complete.
class FilmEncoder {
  public:
    /// Begins the film `file` with `rate` pictures a second of width x height pixels; its
    /// extension must be one of filmFormats(). What ffmpeg writes goes into `unfinished` first,
    /// and into files whose names begin like it, which are gone with this object. Throws
    /// OutputError with a sentence where ffmpeg is missing or the film can't be written.
    FilmEncoder(const std::filesystem::path& file, std::filesystem::path unfinished, int width,
                int height, int rate);
    ~FilmEncoder();
    FilmEncoder(const FilmEncoder&) = delete;
    FilmEncoder& operator=(const FilmEncoder&) = delete;

    /// Adds a picture of the size of the film. Throws OutputError, as finish().
    void add(const render::Image& picture);
    /// Lets the film appear.
    void finish();

  private:
    void start(std::vector<std::string> words);
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
    pid_t child_ = 0;  ///< 0 once it is gone
};

}  // namespace kerf::app
