#pragma once

#include <vector>

namespace kerf::app {

/// A specimen on the virtual test bench, and how it is loaded.
enum class SpecimenKind {
    hangingBar,       ///< 0.1 x 0.4 x 0.1 m, its top pinned, pulled by its own weight
    bentBar,          ///< the same bar, its weight acting sideways
    bentSlab,         ///< the same, but 0.5 m wide across the weight
    compressedBlock,  ///< 0.2 m cube that stands on a floor without friction under its own weight
    shearedBlock,     ///< 0.4 x 0.1 x 0.4 m, its bottom pinned, its weight acting sideways
    hangingCube,      ///< 0.2 m cube, its top pinned, pulled by its own weight
    pressedSphere,    ///< of 0.1 m radius, pressed on a floor without friction by its own weight
};

/// One test.
struct BenchSetting {
    SpecimenKind kind = SpecimenKind::hangingBar;
    int cells = 4;            ///< squares across the specimen
    double modulus = 1e5;     ///< the parameter `youngs_modulus` [Pa]
    int iterations = 20;      ///< substeps in a time step
    double timeStep = 0.005;  ///< [s]
    bool trueModulus = true;  ///< the parameter `true_modulus`
    bool operator==(const BenchSetting&) const = default;
};

/// The result of a run on the test bench.
struct BenchResult {
    int triangles = 0;
    double strain = 0;              ///< how far the end went, over the specimen's length
    double effectiveModulus = 0;    ///< [Pa]
    double volumeRatio = 1;         ///< at rest under load, against the unloaded specimen
    bool settled = false;           ///< false where it still moved when time was up
    bool tooFewIterations = false;  ///< the program says so: SweepStrength
};

/// Loads the specimen by a gravity that gives a strain of 1 % at the parameter's modulus, lets it
/// settle, and takes the modulus from how far its end goes. With the weight of the vertices m g, at
/// distances h from the support, a bar of length L and cross-section A changes its length by
/// sum(m g h) / (E A), and a flat block is sheared by 3 times that. One with the second moment of
/// area I that is bent moves its end by sum(m g h^2 (3 L - h)) / (6 E I) (Euler and Bernoulli,
/// without shear). Clamps, width and rims make a solid deviate from these; so does a factor,
/// from finite elements of Poisson's ratio 0.499 (docs/notes/effective-modulus.md). The middle of a
/// sphere of radius R goes down by d, with F = 16/9 E sqrt(R) d^(3/2) (Hertz), 2 % of its diameter.
/// Runs on the GL context that is current.
BenchResult measureModulus(const BenchSetting& setting);

/// Time between two looks of motionOfEnd() [s].
inline constexpr double kLook = 0.02;

/// How far the free end has gone after each of so many looks, from when the weight begins to act
/// [m]. The time step must divide kLook. Runs on the GL context that is current.
std::vector<double> motionOfEnd(const BenchSetting& setting, int looks);

}  // namespace kerf::app
