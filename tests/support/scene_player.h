#pragma once

#include "sim/cut/exact/jitter.h"
#include "sim/mesh/invariants.h"
#include "sim/run/simulation.h"
#include "tests/support/moving_scenes.h"

namespace kerf::test {

/// Where the blade is at 0 <= u <= 1 of its stroke.
using Path = std::function<Blade(double u)>;

/// Plays a scene with a Simulation and measures it.
class ScenePlayer {
  public:
    /// `mesh` at rest, above the floor y = 0. `weightless`: neither gravity nor floor.
    ScenePlayer(const SceneRun& run, SurfaceMesh mesh, bool weightless = false);

    /// In [-amplitude, amplitude], from the run's own numbers.
    double draw(double amplitude) { return draw_.uniform(-amplitude, amplitude); }
    Vec3 drawDirection() { return draw_.direction(); }

    const SurfaceMesh& mesh() { return simulation_.mesh(); }
    /// Of the body as it is now.
    Bounds bounds() { return meshBounds(mesh()); }
    /// Mean of the vertices.
    Vec3 middle();

    /// Hands and pins.
    void execute(const Command& command) { simulation_.execute(command); }
    /// Steps before the first cut; nothing is measured.
    void settle(int steps);
    /// Takes the blade along the path in `steps` steps and lifts it. `through`: it should leave
    /// no end of a slit inside the body.
    void stroke(const Path& path, int steps, bool through = true);
    /// Steps after a stroke.
    void watch(int steps);
    /// `pieces`: how many the strokes should have made.
    SceneFigures finish(int pieces);

  private:
    void cutStep();
    void describeStep(double speed);
    void describeFolds();
    /// Throws std::logic_error: where an end of the blade lies inside, the slit rightly ends there.
    void requireEndsOutside(const Blade& blade);
    void countOutcome(const CutResult& result);
    void readMessages();
    /// Numbers of strokes that made walls, one more than the last.
    int labelsSoFar();
    double topSpeed();
    int chips();
    int slitEdgesLeft();
    void countFolds();

    SceneRun run_;
    cut::Jitter draw_;
    double bodyVolume_;
    double diagonal_;
    double fallSpeed_;  ///< of a fall through the body's height
    Simulation simulation_;
    SceneFigures figures_;
    int refusedInARow_ = 0;
    std::size_t strayedBefore_ = 0;
    std::vector<RungNode> rungBefore_;
    std::vector<int> throughLabels_;  ///< numbers of the strokes that should pass through
};

}  // namespace kerf::test
