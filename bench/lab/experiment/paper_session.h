#pragma once

#include <string>
#include <vector>

#include "app/session/paper_experiments.h"
#include "app/session/session.h"

namespace kerf::app {

/// Steps at which the course of an experiment turns: the blade comes down through the body, then
/// gravity acts and the pieces fall on the floor.
struct Moments {
    int blade = 0;    ///< its first pose
    int lift = 0;     ///< the stroke ends
    int gravity = 0;  ///< it begins to act
    int end = 0;      ///< number of steps
};
/// The moments of a session of assets/sessions. Throws InputError where a session has no stroke.
Moments momentsOf(const Session& session);

/// A picture that a report shows, and what it says below it.
struct ReportPicture {
    int step = 0;         ///< of the run, before which it is taken
    std::string file;     ///< relative to the folder of the run
    std::string caption;  ///< "half way"
};
/// The pictures of the cut (the paper's figures 5 and 6): before, half way, through, parted.
std::vector<ReportPicture> cuttingPictures(const Session& session);
/// The pictures of the fall (the paper's figures 7 and 8): at the session's own screenshots behind
/// the cut, from the impact on.
std::vector<ReportPicture> fallPictures(const Session& session);

/// The session of an experiment, with the paper's solver, contact and course of the cut where
/// `published`. Throws InputError.
Session paperSession(const PaperExperiment& experiment, bool published);
/// Widths of the pictures in strips [pixels]: of a cut, and of pieces that move apart.
inline constexpr int kCuttingWidth = 360;
inline constexpr int kFallWidth = 480;
/// The session with these pictures, so wide, besides its own.
Session withPictures(Session session, const std::vector<ReportPicture>& pictures, int width);
/// Gives all pictures of the session the size of those in strips.
void sizePictures(Session& session, int width);
/// The session without pictures and checks, up to the end of its stroke: for timing.
Session strokeAlone(Session session);

/// The experiment that figure 2 shows.
inline constexpr const char* kFigure2Model = "sphere768";
/// The step before which the pictures of figure 2 are taken, in the session of Sphere 768: the
/// halves lie on the floor.
inline constexpr int kFigure2Step = 260;
/// How many steps the runs of figure 2 have.
inline constexpr int kFigure2Steps = 400;
/// The session of figure 2, which takes the picture `file` alone.
Session figure2Session(bool published, double ispcStiffness, const std::string& file);

}  // namespace kerf::app
