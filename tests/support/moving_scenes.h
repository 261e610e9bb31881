#pragma once

namespace kerf::test {

/// One run of a scene: a body is cut while the solver moves it.
struct SceneRun {
    std::string scene;
    double youngsModulus = 1e5;  ///< [Pa]
    int index = 0;               ///< decides offset and tilt of the strokes, together with `seed`
    std::uint64_t seed = 1;
    bool verbose = false;  ///< prints every step of the blade
    bool contact = true;   ///< of the body with itself
    bool push = false;     ///< the body of the blade
    double grading = 1;    ///< wall_coarsening
    int stepsAfter = 50;   ///< that follow the last stroke
};

/// Steps at the end of which all folds are counted: many come and go within a step.
constexpr int kInView = 100;

/// What came of one run, or of several: counts add up, of speeds and rows the largest counts.
struct SceneFigures {
    int runs = 0;
    int attempted = 0;       ///< steps of the blade that cut or were refused
    int refused = 0;         ///< of these
    int longestRefusal = 0;  ///< refused steps in a row
    int retried = 0;         ///< steps that cut, but not at the first try
    int unseparated = 0;     ///< runs with fewer pieces than the strokes should have made
    int slitEdges = 0;       ///< ends of slits left inside by strokes that should pass through
    int nonFinite = 0;       ///< steps in which the body left the range of numbers
    int open = 0;            ///< runs that ended with a mesh that is no closed manifold
    int folded = 0;      ///< edges bent by more than 90 degrees from rest at the end, slivers apart
    int foldedSoon = 0;  ///< the same 50 steps after the last stroke
    int foldedAtPins =
        0;  ///< the same at the end, of edges with a pinned end, which `folded` leaves out
    int foldsInView = 0;      ///< as `folded`, added up over the last kInView steps after a stroke
    int chips = 0;            ///< pieces below 1e-4 of the body
    double speedCutting = 0;  ///< while cutting, in speeds of a fall through the body's height
    double speedAfter = 0;    ///< after a stroke [diagonals/s]
    double seconds = 0;       ///< wall time

    void add(const SceneFigures& other);
};

/// Scenes that a cut of a moving body must master: bodies on the floor cut right through, a banana
/// pinned at both ends cut where it opens and where it closes on the blade, an arm and a head, an
/// incision that is pulled open and a second one across, a body at rest, halves cut again while
/// they roll.
const std::vector<std::string>& movingScenes();
/// Others: a banana that stands as an arch, whose halves fall on their cut ends, incisions that
/// nobody pulls open, strokes in random planes through bodies on the floor.
const std::vector<std::string>& furtherScenes();

/// Plays one run with a Simulation on the GL context that is current.
/// Throws std::invalid_argument for an unknown scene.
SceneFigures playScene(const SceneRun& run);

/// A table as text, one row for each scene and modulus.
std::string sceneTableHead();
std::string sceneTableRow(const SceneRun& run, const SceneFigures& figures);

}  // namespace kerf::test
