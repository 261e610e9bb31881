#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/cli/replay/film_captions.h"
#include "app/cli/replay/picture_size.h"
#include "app/files/film/film_encoder.h"
#include "render/scene/camera_path.h"
#include "sim/run/parts/command.h"
#include "ui/base/picture_painter.h"

namespace kerf::app {

/// What a film of a session is to be.
struct FilmOptions {
    std::filesystem::path file;  ///< its extension is one of filmFormats(); empty for no film
    PictureSize size;
    int rate = 0;            ///< pictures a second; 0: what suits the format
    double speed = 1;        ///< simulated seconds in a second of the film
    bool turntable = false;  ///< the camera turns about its target once, from the start to the end
    bool captions = false;   ///< with the time, and what happens
};

/// What became of a film.
struct FilmReport {
    int frames = 0;
    double seconds = 0;  ///< that it lasts
};

/// Tells which frames of a film show the state before a step: the first state that is not before
/// the moment of the frame.
class FilmClock {
  public:
    /// `secondsPerFrame`: simulated time from a frame to the next [s].
    explicit FilmClock(double secondsPerFrame) : secondsPerFrame_(secondsPerFrame) {}

    /// A step is done that lasts so long [s].
    void pass(double seconds);
    /// Takes the next frame, if it shows the state as it is now: how far its moment lies before
    /// this state, as a share of the step that led here. None where a later state is to come.
    std::optional<double> takeFrame();
    /// Time of the steps so far [s].
    double elapsed() const { return elapsed_; }
    int frames() const { return frames_; }

  private:
    double secondsPerFrame_;
    double elapsed_ = 0;
    double lastStep_ = 0;
    int frames_ = 0;
};

/// Films a run of a session.
class Film {
  public:
    /// Draws the scene as it is now.
    using Draw = std::function<render::Image(const render::Camera& camera, const PictureSize&)>;

    /// Begins a film of a run of so many steps, seen along `path` where that has keys. What is not
    /// finished yet lies in the file `unfinished`. Needs a current OpenGL context. Throws
    /// OutputError, as all functions here.
    Film(const FilmOptions& options, const std::filesystem::path& unfinished, int steps,
         render::CameraPath path);

    /// Something happens before the coming step.
    void note(const Command& command);
    /// Films the state before a step, `time` into the simulation [s], as often as it is seen. By
    /// `camera`, where there is no path.
    void show(int step, double time, const render::Camera& camera, const Draw& draw);
    /// A step is done. It lasts its time step [s]; where time stands, what the hand took for it.
    void pass(double timeStep, bool timeRuns);
    /// Lets the film appear.
    FilmReport finish();

  private:
    /// The camera at a moment [steps].
    render::Camera cameraAt(double moment, const render::Camera& camera) const;
    void caption(render::Image& picture, double time);
    double filmTime() const { return clock_.elapsed() / options_.speed; }

    FilmOptions options_;
    int rate_;
    int steps_;
    render::CameraPath path_;
    FilmClock clock_;
    std::optional<double> handSeconds_;  ///< of the coming step
    FilmEncoder encoder_;
    FilmCaptions captions_;
    std::optional<ui::PicturePainter> painter_;
};

}  // namespace kerf::app
