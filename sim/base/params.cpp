#include "sim/base/params.h"

#include <charconv>
#include <cstdio>

#include "sim/base/text.h"

namespace kerf {

namespace {

using Member =
    std::variant<double Params::*, int Params::*, Vec3 Params::*, std::optional<double> Params::*,
                 SolverMode Params::*, CutSearch Params::*>;

// In the order of the enumerators.
constexpr std::array<std::string_view, 2> kSolverModes{"implicit", "pbd"};
constexpr std::array<std::string_view, 3> kCutSearches{"tree", "adjacency", "all"};

struct Row {
    ParamInfo info;
    Member member;
    std::optional<double> OwnMaterial::*own = nullptr;  ///< where models may have one
};

constexpr ParamInfo newer(ParamInfo info) {
    info.isNewer = true;
    return info;
}

constexpr std::array<std::string_view, 1> kAuto{"auto"};

constexpr ParamInfo orAuto(ParamInfo info) {
    info.choices = kAuto;
    return info;
}

const std::array kRows = {
    Row{{"time_step", "Time step", "s",
         "Simulated time per step: commands, cuts and pictures come once in it. The implicit "
         "solver divides it as material, size and contacts need.",
         ParamType::real, 0.0005, 0.02, true},
        &Params::timeStep},
    Row{orAuto({"iterations", "Iterations", "",
                "Of conjugate gradients, in each of the two stages of an implicit step: more is "
                "more exact and slower. With pbd sweeps. auto: as many as each step needs.",
                ParamType::integer, 1, 60, false}),
        &Params::iterations},
    Row{newer({"iteration_error", "Iteration error", "",
               "With auto iterations, about the error that they and the steps may add to a "
               "motion, as a share of it.",
               ParamType::real, 0.002, 0.05, true}),
        &Params::iterationError},
    Row{{"ispc_stiffness", "Internal stiffness", "",
         "How firmly the inside holds the skin apart: 0 is hollow and collapses, 0.5 the material "
         "itself, 1 as firm as the solver gets.",
         ParamType::real, 0, 1, false},
        &Params::ispcStiffness},
    Row{{"gravity", "Gravity", "m/s^2", "Acceleration of free fall along x, y (up) and z.",
         ParamType::vector, -100, 100, false},
        &Params::gravity},
    Row{{"floor", "Floor", "m", "Height of the floor; none without a value.",
         ParamType::optionalReal, -1e7, 1e7, false},
        &Params::floor},
    Row{{"youngs_modulus", "Young's modulus", "Pa",
         "Stiffness of the material: 1e5 is a soft sponge, 1e7 rubber. Not used by pbd.",
         ParamType::real, 1e3, 1e8, true},
        &Params::youngsModulus,
        &OwnMaterial::youngsModulus},
    Row{{"density", "Density", "kg/m^3", "Mass per volume: water has 1000.", ParamType::real, 10,
         20000, true},
        &Params::density,
        &OwnMaterial::density},
    Row{{"stretch_stiffness", "Stretch stiffness", "",
         "Factor on how strongly the skin resists stretching; 0 switches that off. With pbd the "
         "stiffness itself, up to 1.",
         ParamType::real, 0, 10, false},
        &Params::stretchStiffness},
    Row{{"bending_stiffness", "Bending stiffness", "",
         "Factor on how strongly the skin resists bending; 0 switches that off. With pbd the "
         "stiffness itself, up to 1.",
         ParamType::real, 0, 10, false},
        &Params::bendingStiffness},
    Row{{"air_drag", "Air drag", "1/s",
         "Rate at which all motion fades, so that speed falls as exp(-rate * time).",
         ParamType::real, 0, 20, false},
        &Params::airDrag},
    Row{{"damping", "Damping", "s",
         "Inner friction: the time over which the material resists a change of shape. Not used by "
         "pbd.",
         ParamType::real, 0, 0.02, false},
        &Params::damping},
    Row{newer({"skin_thickness", "Skin thickness", "m",
               "How thick a skin of its own lies over the flesh, as that of a fruit; 0: none. Cut "
               "faces have none. Not used by pbd.",
               ParamType::real, 0, 0.05, false}),
        &Params::skinThickness},
    Row{newer(
            {"skin_modulus", "Skin modulus", "Pa",
             "Young's modulus of that skin, which stretches and squeezes with the flesh below it.",
             ParamType::real, 1e3, 1e9, true}),
        &Params::skinModulus},
    Row{{"friction", "Friction", "", "Coulomb coefficient of everything that touches.",
         ParamType::real, 0, 2, false},
        &Params::friction},
    Row{{"contact", "Contact", "",
         "1: pieces, both sides of a slit and arms meet one another; 0: they pass through.",
         ParamType::integer, 0, 1, false},
        &Params::contact},
    Row{{"paper_contact", "Paper's contact", "",
         "1: instead of contact, pieces meet as in the paper, for comparison: once a time step, on "
         "the CPU, triangles that meet lose their relative speed.",
         ParamType::integer, 0, 1, false},
        &Params::paperContact},
    Row{{"contact_thickness", "Contact thickness", "",
         "Distance kept between surfaces that were never one, as a share of the edge length of "
         "walls.",
         ParamType::real, 0, 0.3, false},
        &Params::contactThickness},
    Row{{"depenetration_speed", "Depenetration speed", "m/s",
         "How fast surfaces that have got into one another come apart.", ParamType::real, 0.01, 10,
         true},
        &Params::depenetrationSpeed},
    Row{{"blade_push", "Blade pushes", "",
         "1: what lies behind the blade's edge is a plate that pushes: it holds a slit open, and "
         "its "
         "back and its sides move what they meet; 0: the blade only cuts.",
         ParamType::integer, 0, 1, false},
        &Params::bladePush},
    Row{{"blade_width", "Blade width", "",
         "How far the pushing blade reaches back from its edge, as a share of the model's "
         "diagonal.",
         ParamType::real, 0.02, 1, false},
        &Params::bladeWidth},
    Row{{"blade_thickness", "Blade thickness", "",
         "How thick the pushing blade is, as a share of the model's diagonal: so wide it holds a "
         "slit.",
         ParamType::real, 0.001, 0.1, false},
        &Params::bladeThickness},
    Row{newer({"blade_feels", "Blade feels", "",
               "1: the material holds the blade's edge back, and yields under it until the force "
               "suffices for the new surface; 0: the edge cuts without a force. Not used by pbd.",
               ParamType::integer, 0, 1, false}),
        &Params::bladeFeels},
    Row{newer(
            {"toughness", "Toughness", "J/m^2",
             "Energy that a square metre of new surface takes: gelatin 1, liver 160, muscle 2000. "
             "Moves nothing unless the blade feels or the body tears.",
             ParamType::real, 0, 1e6, false}),
        &Params::toughness},
    Row{newer({"blade_bluntness", "Blade bluntness", "",
               "How much more force a blade that feels needs to break in than to go on, as a share "
               "of the latter: 0 is as sharp as can be.",
               ParamType::real, 0, 5, false}),
        &Params::bladeBluntness},
    Row{newer({"tearing", "Tearing", "",
               "1: the body tears where pulling it apart releases the energy that new surface "
               "takes; 0: only a blade cuts. Not used by pbd.",
               ParamType::integer, 0, 1, false}),
        &Params::tearing},
    Row{newer(
            {"tensile_strength", "Tensile strength", "Pa",
             "Stress at which an uncut place begins to tear: gelatin 5 kPa, skin 20 MPa. Too high "
             "for the mesh, it is lowered to what the mesh can resolve.",
             ParamType::real, 1, 1e9, true}),
        &Params::tensileStrength},
    Row{newer({"skin_toughness", "Skin toughness", "J/m^2",
               "Energy that a square metre of new surface takes in the skin layer, while the body "
               "tears.",
               ParamType::real, 0, 1e6, false}),
        &Params::skinToughness},
    Row{newer({"skin_tensile_strength", "Skin tensile strength", "Pa",
               "Stress at which the skin layer begins to tear.", ParamType::real, 1, 1e9, true}),
        &Params::skinStrength},
    Row{newer(
            {"sleeps", "Sleeps at rest", "",
             "1: a body that has lain still for a second is not solved until something is done to "
             "it; 0: it is solved in every step.",
             ParamType::integer, 0, 1, false}),
        &Params::sleeps},
    Row{{"wall_coarsening", "Wall coarsening", "",
         "How much longer edges may be inside a new wall than at its rim; 1 makes all alike.",
         ParamType::real, 1, 10, false},
        &Params::wallCoarsening},
    Row{{"debris_volume", "Debris volume", "",
         "When a stroke ends, pieces that it left with less than this share of the body's volume "
         "are "
         "removed; 0 keeps all.",
         ParamType::real, 0, 0.001, false},
        &Params::debrisVolume},
    Row{{"open_cut", "Open cut", "",
         "1: cut as the paper does, for comparison: the body is hollow while the blade is in it, "
         "and "
         "each wound is patched when the stroke ends. From the next stroke on.",
         ParamType::integer, 0, 1, false},
        &Params::openCut},
    Row{{"cut_search", "Cut search", "",
         "How the triangles near the blade are found, for comparison; the cut is the same. tree: "
         "by "
         "where they lie; adjacency: the paper's walk from seed to neighbours; all: each one is "
         "tested.",
         ParamType::choice, 0, 2, false, kCutSearches, false},
        &Params::cutSearch},
    Row{{"solver", "Solver", "",
         "implicit: a few large steps of a material in pascals, which its firmness does not "
         "shorten; pbd: the paper's sweeps and stiffness factors, which lose volume.",
         ParamType::choice, 0, 1, false, kSolverModes},
        &Params::solver},
};

const Row* findRow(std::string_view name) {
    const auto row = std::ranges::find_if(kRows, [&](const Row& r) { return r.info.name == name; });
    return row == kRows.end() ? nullptr : &*row;
}

constexpr char kOfModel = '@';

/// A parameter of one model: "density@2".
struct OwnParam {
    const Row* row = nullptr;
    int model = 0;
};

/// None where the name is none of these.
std::optional<OwnParam> findOwn(std::string_view name) {
    const std::size_t split = name.find(kOfModel);
    const std::string_view digits = split < name.size() ? name.substr(split + 1) : "";
    OwnParam found{findRow(name.substr(0, split)), 0};
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), found.model);
    const bool number = error == std::errc{} && end == digits.data() + digits.size() &&
                        digits.front() != '0' && found.model >= 1 && found.model < kMostModels;
    return number && found.row != nullptr && found.row->own != nullptr ? std::optional(found)
                                                                       : std::nullopt;
}

std::string quoted(std::string_view name) {
    return "\"" + std::string(name) + "\"";
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string unknownParam(std::string_view name) {
    std::string known;
    for (const Row& row : kRows) {
        known += (known.empty() ? "" : ", ") + std::string(row.info.name);
    }
    return "there is no parameter " + quoted(name) + "; known are " + known;
}

std::string checkNumber(const ParamInfo& info, double value) {
    if (!std::isfinite(value)) {
        return quoted(info.name) + " must be a finite number";
    }
    if (value < info.low || value > info.high) {
        return quoted(info.name) + " must lie between " + number(info.low) + " and " +
               number(info.high) + (info.unit.empty() ? "" : " " + std::string(info.unit)) +
               ", not " + number(value);
    }
    if (info.type == ParamType::integer && value != std::floor(value)) {
        return quoted(info.name) + " must be a whole number, not " + number(value);
    }
    return "";
}

/// Writes a value of the wrong type as a sentence, of the right type into the parameters.
struct Setter {
    Params& params;
    const ParamInfo& info;
    const ParamValue& value;

    std::string operator()(double Params::*member) const {
        return setNumber([&](double x) { params.*member = x; });
    }
    std::string operator()(int Params::*member) const {
        const std::string* word = std::get_if<std::string>(&value);
        if (word != nullptr && std::ranges::find(info.choices, *word) != info.choices.end()) {
            params.*member = 0;
            return "";
        }
        return setNumber([&](double x) { params.*member = static_cast<int>(x); });
    }
    std::string operator()(std::optional<double> Params::*member) const {
        if (std::holds_alternative<std::monostate>(value)) {
            params.*member = std::nullopt;
            return "";
        }
        return setNumber([&](double x) { params.*member = x; });
    }
    std::string operator()(Vec3 Params::*member) const {
        const Vec3* vector = std::get_if<Vec3>(&value);
        if (!vector) {
            return quoted(info.name) + " takes three numbers";
        }
        for (const double component : *vector) {
            if (std::string problem = checkNumber(info, component); !problem.empty()) {
                return problem;
            }
        }
        params.*member = *vector;
        return "";
    }
    template <class Choice>
    std::string operator()(Choice Params::*member) const {
        const std::string* name = std::get_if<std::string>(&value);
        if (info.name == "solver" && name && *name == kFormerSolver) {
            params.*member = Choice{};
            return "";
        }
        const auto choice = name ? std::ranges::find(info.choices, *name) : info.choices.end();
        if (choice == info.choices.end()) {
            return quoted(info.name) + " must be one of " + joined(info.choices, ", ");
        }
        params.*member = static_cast<Choice>(choice - info.choices.begin());
        return "";
    }

    template <class Assign>
    std::string setNumber(Assign&& assign) const {
        const double* x = std::get_if<double>(&value);
        if (!x) {
            return quoted(info.name) + " takes one number from " + number(info.low) + " to " +
                   number(info.high) + (info.unit.empty() ? "" : " " + std::string(info.unit)) +
                   (info.type == ParamType::optionalReal ? ", or null for none" : "") +
                   (info.choices.empty() ? "" : ", or " + quoted(info.choices.front()));
        }
        std::string problem = checkNumber(info, *x);
        if (problem.empty()) {
            assign(*x);
        }
        return problem;
    }
};

/// Reads a member as the value that sets it.
struct Getter {
    const Params& params;
    const ParamInfo& info;

    ParamValue operator()(double Params::*member) const { return params.*member; }
    ParamValue operator()(int Params::*member) const {
        const int x = params.*member;
        return x == 0 && !info.choices.empty() ? ParamValue(std::string(info.choices.front()))
                                               : ParamValue(static_cast<double>(x));
    }
    ParamValue operator()(Vec3 Params::*member) const { return params.*member; }
    ParamValue operator()(std::optional<double> Params::*member) const {
        const std::optional<double>& x = params.*member;
        return x ? ParamValue(*x) : ParamValue(std::monostate{});
    }
    template <class Choice>
    ParamValue operator()(Choice Params::*member) const {
        return std::string(info.choices[static_cast<std::size_t>(params.*member)]);
    }
};

ParamValue getOwn(const Params& params, const OwnParam& own) {
    const std::size_t place = own.model - 1;
    if (place >= params.models.size() || !(params.models[place].*own.row->own)) {
        return std::monostate{};
    }
    return *(params.models[place].*own.row->own);
}

std::string setOwn(Params& params, const OwnParam& own, const ParamValue& value) {
    const std::size_t place = own.model - 1;
    const auto assign = [&](const std::optional<double>& number) {
        params.models.resize(std::max(params.models.size(), place + 1));
        params.models[place].*own.row->own = number;
    };
    if (std::holds_alternative<std::monostate>(value)) {
        assign(std::nullopt);
        return "";
    }
    ParamInfo info = own.row->info;
    info.type = ParamType::optionalReal;
    return Setter{params, info, value}.setNumber(assign);
}

}  // namespace

Params ofNewScene(Params params) {
    params.sleeps = 1;
    params.wallCoarsening = 3;
    return params;
}

std::span<const ParamInfo> paramTable() {
    static const std::vector<ParamInfo> table = [] {
        std::vector<ParamInfo> infos;
        infos.reserve(kRows.size());
        for (const Row& row : kRows) {
            infos.push_back(row.info);
            infos.back().perModel = row.own != nullptr;
        }
        return infos;
    }();
    return table;
}

std::string ownName(std::string_view param, int model) {
    return std::string(param).append(1, kOfModel).append(std::to_string(model));
}

int modelOf(std::string_view param) {
    const std::optional<OwnParam> own = findOwn(param);
    return own ? own->model : 0;
}

std::vector<std::string> ownNames(const Params& params) {
    std::vector<std::string> names;
    for (std::size_t m = 0; m < params.models.size(); ++m) {
        for (const Row& row : kRows) {
            if (row.own != nullptr && params.models[m].*row.own) {
                names.push_back(ownName(row.info.name, static_cast<int>(m) + 1));
            }
        }
    }
    return names;
}

const ParamInfo* findParam(std::string_view name) {
    const std::optional<OwnParam> own = findOwn(name);
    const Row* row = own ? own->row : findRow(name);
    return row ? &row->info : nullptr;
}

ParamValue getParam(const Params& params, std::string_view name) {
    if (const std::optional<OwnParam> own = findOwn(name)) {
        return getOwn(params, *own);
    }
    const Row* row = findRow(name);
    return row ? std::visit(Getter{params, row->info}, row->member) : ParamValue(std::monostate{});
}

std::string setParam(Params& params, std::string_view name, const ParamValue& value) {
    if (const std::optional<OwnParam> own = findOwn(name)) {
        return setOwn(params, *own, value);
    }
    const Row* row = findRow(name);
    return row ? std::visit(Setter{params, row->info, value}, row->member) : unknownParam(name);
}

bool operator==(const Params& a, const Params& b) {
    const std::vector<std::string> own = ownNames(a);
    const auto same = [&](std::string_view name) { return getParam(a, name) == getParam(b, name); };
    return own == ownNames(b) && std::ranges::all_of(own, same) &&
           std::ranges::all_of(kRows, [&](const Row& row) { return same(row.info.name); });
}

}  // namespace kerf
