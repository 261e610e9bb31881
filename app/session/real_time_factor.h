#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/base/params.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

class Simulation;
}

namespace kerf::app {

/// The real-time factor: simulated time over time of the clock. 1 is real time, 0.03 slow motion,
/// 33 times slower. None where no time passed.
std::optional<double> realTimeFactor(double simulatedSeconds, double milliseconds);

/// The simulated time of the last step [s]; 0 while time is paused.
double secondsOfStep(const Simulation& simulation);

/// The real-time factors of a run. Steps while time is paused do not count.
class RealTimeFactors {
  public:
    /// A step of `simulatedSeconds` that took `stepMs`, after pictures that took `pictureMs`.
    void add(double simulatedSeconds, double stepMs, double pictureMs);
    /// Of single steps: the middle one (of an even number the upper of the two), and the smallest.
    std::optional<double> median() const;
    std::optional<double> worst() const;
    /// Of all steps together with the pictures before them.
    std::optional<double> withDrawing() const;
    /// "0.52 s simulated in 14 s, 0.037x real time (slowest step 0.021x)"; with pictures those too.
    std::string sentence() const;

  private:
    double simulated_ = 0;
    double stepMs_ = 0;
    double pictureMs_ = 0;
    std::vector<double> ofSteps_;
};
/// As in summary.json: `median`, `worst` and `with_drawing`, null where no time passed.
nlohmann::ordered_json toJson(const RealTimeFactors& factors);

/// How fast a body that has landed will move on this machine, whole and without drawing.
struct RealTimeForecast {
    double factor = 0;      ///< see realTimeFactor()
    double timeStep = 0;    ///< [s]
    int iterations = 0;     ///< of a step
    int implicitSteps = 1;  ///< that a time step is made of; 1 with other solvers
    double scale = 1;       ///< times as long as what was measured
};

/// Runs a few steps of `mesh`, placed in the world, on the OpenGL context that is current. For one
/// of more than 12,000 triangles a ball of its size stands in, whose times are scaled. Takes part
/// of a second. Throws like Simulation.
RealTimeForecast realTimeForecast(const SurfaceMesh& mesh, const Params& params);

}  // namespace kerf::app
