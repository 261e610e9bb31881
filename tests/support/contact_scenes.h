#pragma once

#include "sim/base/params.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::test {

/// How deep p lies inside a mesh: its distance from the surface where the winding number is over a
/// half, 0 elsewhere. [m]
double depthInside(const SurfaceMesh& mesh, const Vec3& p);

/// A weightless sphere with a slit whose walls still lie close together: half through it, and right
/// through it with 30 steps.
SurfaceMesh slitSphere(int steps = 16);

/// Two halves of a body, cut apart level without gravity, that rest on each other.
struct HalvesFigures {
    double separation = 0;   ///< of their centroids, as a share of that in the whole body at rest
    double height = 0;       ///< of both, as a share of that of the whole body lying there
    double shift = 0;        ///< of their centroids sideways [diagonals]
    double penetration = 0;  ///< depth of the deepest vertex inside the other one [diagonals]
    double jitter = 0;       ///< RMS speed in the last half second [diagonals/s]
    double wholeJitter = 0;  ///< that of the whole body lying there
    int contacts = 0;        ///< in the last substep
};
/// Of a sphere (which rolls, whole or cut) or a block (which stands).
HalvesFigures restHalves(bool sphere, const Params& params, double seconds = 5);
std::string text(const HalvesFigures& figures);

/// An octopus dropped on its arms, three seconds.
struct OctopusFigures {
    int intersectionsAtStart = 0;
    int intersections = 0;  ///< pairs of triangles at the end
    int folds = 0;          ///< those of them that are close neighbours at rest
    int mostContacts = 0;
    double jitter = 0;  ///< RMS speed in the last half second [diagonals/s]
};
OctopusFigures dropOctopus(const Params& params);
std::string text(const OctopusFigures& figures);

/// Times of a step while a model falls from 0.2 m, lands and comes to rest, with contact and
/// without.
struct SpeedFigures {
    double plain = 0;     ///< median without [ms]
    double touching = 0;  ///< median with [ms]
    double plainSum = 0;  ///< of all steps [ms]
    double touchingSum = 0;
    long steps = 0;
};
/// `model`: see builtin().
SpeedFigures timeDrop(const std::string& model, const Params& params, double seconds = 1);
std::string text(const SpeedFigures& figures);

/// What contact costs beside the rest of a step, wall time of all steps together.
struct CostFigures {
    int triangles = 0;
    int steps = 0;
    double deform = 0;   ///< [ms]
    double collide = 0;  ///< [ms]
    double worst = 0;    ///< the largest share of `collide` in a tenth of the steps
    int mostContacts = 0;
    std::string stateHash;  ///< at the end
};
/// 144 balls of 320 triangles poured on the floor.
CostFigures pourBalls(const Params& params, double seconds = 1);
/// A ball of about this many triangles, cut level into two halves and dropped.
CostFigures dropHalves(int triangles, const Params& params, double seconds = 0.5);
std::string text(const CostFigures& figures);

/// Processor time of a step with 64 pieces of 162 vertices each that lie side by side, and of the
/// same ones just thrown, each in another direction.
struct CrowdFigures {
    int vertices = 0;
    double lying = 0;   ///< median [ms of all threads]
    double thrown = 0;  ///< median [ms of all threads]
    double longest = 0;
    std::string stateHash;  ///< at the end
};
/// `speed`: of each [m/s].
CrowdFigures throwCrowd(double speed, const Params& params, int steps = 40);
std::string text(const CrowdFigures& figures);

/// Two spheres without gravity that fly into each other off their middles, spin, and part.
struct CollisionFigures {
    int stepsInContact = 0;
    bool parted = false;
    double linearDrift = 0;   ///< change of momentum as a share of it
    double angularDrift = 0;  ///< the same of angular momentum about their common centre
    double energyLeft = 0;    ///< kinetic at the end, as a share of that at the start
    double penetration = 0;   ///< of the deepest vertex at any step [diagonals of both]
};
CollisionFigures collideSpheres(const Params& params);
std::string text(const CollisionFigures& figures);

struct DropRun {
    std::uint64_t seed = 1;
    int index = 0;
};

/// A body, often two, thrown at the floor and at up to three boxes that stand there.
struct RandomDropFigures {
    int runs = 0;
    int nonFinite = 0;      ///< steps in which a body left the range of numbers
    int escaped = 0;        ///< runs that ended with a vertex below the floor or far away
    int tunnels = 0;        ///< runs that ended with a vertex deep inside another piece or a box,
                            ///< or a corner of a box deep inside a body
    int intersections = 0;  ///< pairs of triangles at the end, of two pieces or of two parts of one
    int crumpled = 0;       ///< the same of close neighbours: skin folded onto itself
    void add(const RandomDropFigures& other);
};
RandomDropFigures dropAtRandom(const DropRun& run, const Params& params);
std::string text(const RandomDropFigures& figures);

}  // namespace kerf::test
