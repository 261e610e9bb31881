#pragma once

#include "app/cli/replay/film.h"
#include "app/files/io/file_io.h"
#include "ui/plots/picture_strip.h"

namespace kerf::app {

/// A row of pictures of a run.
struct StripOptions {
    std::filesystem::path file;  ///< a .png; empty for none
    int pictures = 0;            ///< from the start to the end, at least kFewestStripPictures
    PictureSize size{480, 360};  ///< of each of them
};
inline constexpr int kFewestStripPictures = 2;
/// How many pictures of a size a strip may have, so that every driver can draw it.
int mostStripPictures(const PictureSize& size);

/// Gathers the pictures of a strip while a session runs. The strip appears under its name only once
/// it is complete.
class FilmStrip {
  public:
    /// Throws OutputError if the file can't be written, like all functions here.
    FilmStrip(const StripOptions& options, int steps);

    /// Takes a picture of the state before a step, at simulated `time` [s], if it is one of the
    /// strip.
    void show(int step, double time, const render::Camera& camera, const Film::Draw& draw);
    /// Writes the strip with the pictures so far, under `title`. Needs a current OpenGL context.
    void finish(const std::string& title);

  private:
    /// The step of the next picture.
    int nextStep() const;

    StripOptions options_;
    int steps_;
    AtomicFile file_;
    std::vector<ui::StripPicture> pictures_;
};

}  // namespace kerf::app
