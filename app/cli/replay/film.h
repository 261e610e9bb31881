#pragma once

#include "app/files/film/film_encoder.h"
#include "render/scene/camera.h"
#include "sim/run/parts/command.h"
#include "ui/base/panel_context.h"

namespace kerf::app {

/// Size of a picture [px].
struct PictureSize {
    int width = 1280;
    int height = 720;
};

/// Captions of a film about events of its session.
class FilmCaptions {
  public:
    /// `speed`: simulated seconds in a second of the film.
    explicit FilmCaptions(double speed);

    /// Records a command at a time of the film [s].
    void note(const Command& command, double filmTime);
    /// The caption at a time of the film, at simulated `time` [s]: "0.65 s, 4 times slower. Cut 1".
    /// The last event is shown for a while, a cut as long as its blade is down.
    std::string at(double filmTime, double time) const;

  private:
    void tell(std::string words, double filmTime);

    std::string pace_;   ///< ", 4 times slower"; empty in real time
    std::string words_;  ///< empty for none
    double since_ = 0;   ///< of the film [s]
    bool bladeIsDown_ = false;
    int cuts_ = 0;
};

/// Options of a film of a session.
struct FilmOptions {
    std::filesystem::path file;  ///< its extension is one of filmFormats(); empty for no film
    PictureSize size;
    int rate = 0;            ///< frames a second; 0: the format's default
    double speed = 1;        ///< simulated seconds in a second of the film
    bool turntable = false;  ///< the camera turns about its target once, from the start to the end
    bool captions = false;   ///< with time and events
};

/// The result of a film.
struct FilmReport {
    int frames = 0;
    double seconds = 0;  ///< its length
};

/// Assigns frames of a film to states: a frame shows the first state that is not before its time.
class FilmClock {
  public:
    /// `secondsPerFrame`: simulated time from a frame to the next [s].
    explicit FilmClock(double secondsPerFrame) : secondsPerFrame_(secondsPerFrame) {}

    /// Records a command before the coming step.
    void note(const Command& command);
    /// Advances by a step, which lasts its time step [s]; while time stands, as long as the person
    /// took.
    void pass(double timeStep, bool timeRuns = true);
    /// Takes the next frame, if it shows the present state: how far its time is before this state,
    /// as a share of the last step. None if it shows a later state.
    std::optional<double> takeFrame();
    /// Time of the steps so far [s].
    double elapsed() const { return elapsed_; }
    int frames() const { return frames_; }

  private:
    double secondsPerFrame_;
    std::optional<double> handSeconds_;  ///< of the coming step
    double elapsed_ = 0;
    double lastStep_ = 0;
    int frames_ = 0;
};

/// Films a run of a session.
class Film {
  public:
    /// Draws the present scene.
    using Draw = std::function<render::Image(const render::Camera& camera, const PictureSize&)>;

    /// Begins a film of a run of `steps` steps, seen along `path` if that has keys. Unfinished
    /// output is in the file `unfinished`. Needs a current OpenGL context. Throws OutputError, like
    /// all functions here.
    Film(const FilmOptions& options, const std::filesystem::path& unfinished, int steps,
         render::CameraPath path);

    /// Records a command before the coming step.
    void note(const Command& command);
    /// Films the state before a step, at simulated `time` [s], in all its frames. By `camera`
    /// without a path.
    void show(int step, double time, const render::Camera& camera, const Draw& draw);
    /// After a step: see FilmClock::pass.
    void pass(double timeStep, bool timeRuns) { clock_.pass(timeStep, timeRuns); }
    /// Completes the film.
    FilmReport finish();

  private:
    /// The camera at a time [steps].
    render::Camera cameraAt(double moment, const render::Camera& camera) const;
    void caption(render::Image& picture, double time);
    double filmTime() const { return clock_.elapsed() / options_.speed; }

    FilmOptions options_;
    int rate_;
    int steps_;
    render::CameraPath path_;
    FilmClock clock_;
    FilmEncoder encoder_;
    FilmCaptions captions_;
    std::optional<ui::PicturePainter> painter_;
};

}  // namespace kerf::app
