#pragma once

#include "sim/base/math.h"

namespace kerf {

/// How the triangles near the blade's strip are found. All find the same.
enum class CutSearch {
    tree,       ///< by position, in a tree of boxes or as listed by the GPU
    adjacency,  ///< as in the paper: a seed, then from neighbour to neighbour
    all,        ///< each triangle of the body is tested, as before the paper
};

/// How the constraints are solved.
enum class SolverMode {
    implicit,  ///< large implicit steps of a material in pascals: see ImplicitStepper
    pbd,       ///< plain position-based dynamics, as in the paper: sweeps and stiffness factors
};

/// The parameters of a single model of a scene; those without a value are those of all models.
struct OwnMaterial {
    std::optional<double> youngsModulus;  ///< [Pa]
    std::optional<double> density;        ///< [kg/m^3]

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(youngsModulus, density);
    }
};

/// Models that a scene may consist of.
inline constexpr int kMostModels = 64;

/// Params::iterations: the simulation chooses them before each step; "auto" in text.
inline constexpr int kAutoIterations = 0;
/// As many sweeps of pbd, where iterations are auto.
inline constexpr int kUsualSweeps = 20;
/// A solver that sessions of before may name: setParam() takes it for SolverMode::implicit.
inline constexpr std::string_view kFormerSolver = "small_steps";

/// How the blade acts on the body.
struct BladeParams {
    int bladePush = 0;             ///< 1: the plate behind the edge pushes; 0: not
    double bladeWidth = 0.15;      ///< of that plate, as a share of the uncut body's diagonal
    double bladeThickness = 0.01;  ///< the same of its thickness
    int bladeFeels = 0;            ///< 1: the edge cuts only where its force suffices
    double toughness = 100;        ///< energy per area of new surface [J/m^2]
    double bladeBluntness = 0.5;   ///< extra share of force for crack initiation
};

/// Where the body tears. See docs/physics.md.
struct TearParams {
    int tearing = 0;               ///< 1: it tears where it is pulled apart; 0: only a blade cuts
    double tensileStrength = 5e4;  ///< stress at which the material begins to part [Pa]
    double skinToughness = 1000;   ///< energy per area of new surface of the skin layer [J/m^2]
    double skinStrength = 1e6;     ///< tensile strength of the skin layer [Pa]
};

/// The parameters of a scene as a whole.
struct SceneParams : BladeParams, TearParams {
    SolverMode solver = SolverMode::implicit;
    double timeStep = 0.005;  ///< [s]
    /// Of a stage of an implicit step, or sweeps of pbd; kAutoIterations: as many as each step
    /// needs.
    int iterations = kAutoIterations;
    double iterationError = 0.02;       ///< that auto iterations are to keep to, as a share
    double ispcStiffness = 0.5;         ///< 0 (none) to 1 (firm)
    Vec3 gravity = {0, -9.81, 0};       ///< [m/s^2]
    std::optional<double> floor = 0.0;  ///< height [m]; none without a value
    double youngsModulus = 1e5;         ///< [Pa]
    double density = 1000;              ///< [kg/m^3]
    double stretchStiffness = 1;        ///< factor on the edges' modulus; stiffness k in pbd
    double bendingStiffness = 1;        ///< factor on the bends' modulus; stiffness k in pbd
    double airDrag = 1;                 ///< velocity decay c in v exp(-c t) [1/s]
    double damping = 0.001;             ///< stiffness-proportional damping time beta [s]
    double skinThickness = 0;           ///< of a skin layer over the flesh; 0: none [m]
    double skinModulus = 1e6;           ///< its Young's modulus [Pa]
    double wallCoarsening = 1;          ///< edge length inside finished walls over that at the rim
    double debrisVolume = 1e-5;         ///< share of the body below which pieces are removed
    int openCut = 0;                    ///< 1: the paper's course, hollow until the stroke ends
    CutSearch cutSearch = CutSearch::tree;  ///< how triangles near the blade are found
    double friction = 0.5;                  ///< Coulomb coefficient of all contacts
    int contact = 1;                        ///< 1: pieces, slits and limbs collide; 0: not
    int paperContact = 0;                   ///< 1: the paper's response of pieces instead
    double contactThickness = 0.05;  ///< distance kept, as a share of the edge length of walls
    double depenetrationSpeed = 1;   ///< at which penetrations are resolved [m/s]
    int sleeps = 0;                  ///< 1: a body at rest is not solved until it is disturbed
};

/// Everything that a person can tune. paramTable() has names, ranges and meanings.
struct Params : SceneParams {
    std::vector<OwnMaterial> models = {};  ///< of models 1, 2, ...; those behind have none
    /// Of how many implicit steps the coming time step is made; chosen by the run, no parameter.
    int implicitSteps = 1;

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        SceneParams scene = *this;
        scene.floor = floor.value_or(0.0);  // or its bytes would be anything
        std::optional<double> height = floor;
        io(scene, height, models);
        if constexpr (Archive::kReads) {
            scene.floor = height;
            static_cast<SceneParams&>(*this) = scene;
        }
    }
};

/// A number, a vector, nothing (for parameters that may be absent, like the floor), or a choice.
using ParamValue = std::variant<double, Vec3, std::monostate, std::string>;

/// Which kind of value a parameter takes.
enum class ParamType { real, integer, vector, optionalReal, choice };

/// One row of the table that the panels, the session file and the docs share.
struct ParamInfo {
    std::string_view name;     ///< as in a session: "time_step"
    std::string_view label;    ///< as in the panel: "Time step"
    std::string_view unit;     ///< "s", "" for none
    std::string_view meaning;  ///< one sentence for the tooltip and the docs
    ParamType type = ParamType::real;
    double low = 0;            ///< smallest allowed value (of each component)
    double high = 0;           ///< largest
    bool logarithmic = false;  ///< slider scale
    /// What a choice may be; of an integer, the word that may stand for it, which is 0 then.
    std::span<const std::string_view> choices = {};
    bool changesStates = true;  ///< whether it affects later states
    bool perModel = false;      ///< a model may override it: see ownName()
    /// Whether it was added after hash files existed: at its default it is not hashed.
    bool isNewer = false;
};

/// `params` with what a new scene begins with, which has no bits to keep: sleep at rest, graded
/// walls. What a session leaves out has the default of Params
/// instead.
Params ofNewScene(Params params);
/// All parameters, in the order in which panels and sessions list them.
std::span<const ParamInfo> paramTable();
/// The name of a parameter of one model: "density@2" is the density of model 2. Model 0 has the
/// parameter itself.
std::string ownName(std::string_view param, int model);
/// The model whose own parameter has this name; 0 for one of all models.
int modelOf(std::string_view param);
/// The names of all parameters of single models, model by model.
std::vector<std::string> ownNames(const Params& params);
/// The row of a parameter, or of one of a model's own; null for an unknown name.
const ParamInfo* findParam(std::string_view name);
/// The value that setParam would set it to; std::monostate for an unknown name.
ParamValue getParam(const Params& params, std::string_view name);
/// Sets a parameter. One of a model's own takes a number, or none: that of all models. Returns ""
/// or one clause without a full stop that says why not (unknown name, wrong type, not finite, out
/// of range); the parameters are then unchanged.
std::string setParam(Params& params, std::string_view name, const ParamValue& value);
bool operator==(const Params& a, const Params& b);

}  // namespace kerf
