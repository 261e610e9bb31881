#pragma once

namespace kerf::app {

/// A specimen on the virtual test bench, and how it is loaded.
enum class SpecimenKind {
    hangingBar,       ///< 0.1 x 0.4 x 0.1 m, its top pinned, pulled by its own weight
    bentBar,          ///< the same bar, its weight acting sideways
    bentSlab,         ///< the same, but 0.5 m wide across the weight
    compressedBlock,  ///< 0.2 m cube that stands on a floor without friction under its own weight
};

/// One test.
struct BenchSetting {
    SpecimenKind kind = SpecimenKind::hangingBar;
    int cells = 4;         ///< squares across the specimen
    double modulus = 1e5;  ///< the parameter `youngs_modulus` [Pa]
    int iterations = 20;   ///< substeps of 5 ms
    double ispcStiffness = 0.5;
};

/// The result of a run on the test bench.
struct BenchResult {
    int triangles = 0;
    double strain = 0;            ///< how far the end went, over the specimen's length
    double effectiveModulus = 0;  ///< [Pa]
    double volumeRatio = 1;       ///< at rest under load, against the unloaded specimen
    bool settled = false;         ///< false where it still moved when time was up
};

/// Loads the specimen by a gravity that gives a strain of 1 % at the parameter's modulus, lets it
/// settle, and takes the modulus from how far its end goes. With the weight of the vertices m g, at
/// distances h from the support, a bar of length L and cross-section A changes its length by
/// sum(m g h) / (E A); one with the second moment of area I that is bent moves its end by
/// sum(m g h^2 (3 L - h)) / (6 E I) (Euler and Bernoulli, without shear). Runs on the GL context
/// that is current.
BenchResult measureModulus(const BenchSetting& setting);

}  // namespace kerf::app
