#include "sim/base/params.h"

namespace kerf {
namespace {

TEST(Params, NamesAreUniqueAndEveryRowIsDescribed) {
    std::set<std::string_view> names;
    for (const ParamInfo& info : paramTable()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_FALSE(info.label.empty()) << info.name;
        EXPECT_TRUE(info.meaning.ends_with('.')) << info.name;
        EXPECT_LT(info.low, info.high) << info.name;
        EXPECT_TRUE(!info.logarithmic || info.low > 0) << info.name;
        EXPECT_EQ(findParam(info.name)->name, info.name);
    }
    for (const char* name : {"time_step", "iterations", "ispc_stiffness", "gravity", "floor"}) {
        EXPECT_EQ(names.count(name), 1u) << name;
    }
}

TEST(Params, DefaultsAreInRangeAndRoundTrip) {
    const Params defaults;
    Params copy;
    for (const ParamInfo& info : paramTable()) {
        EXPECT_EQ(setParam(copy, info.name, getParam(defaults, info.name)), "") << info.name;
    }
    EXPECT_TRUE(copy == defaults);
}

/// Valid, and not the default.
ParamValue anotherValue(const ParamInfo& info) {
    switch (info.type) {
        case ParamType::vector:
            return Vec3(info.low, info.high, 0.5 * info.low);
        case ParamType::choice: {
            const auto last = std::string(info.choices.back());
            const bool isLast = getParam(Params{}, info.name) == ParamValue(last);
            return isLast ? std::string(info.choices.front()) : last;
        }
        default: {
            const bool isHigh = getParam(Params{}, info.name) == ParamValue(info.high);
            return isHigh ? info.low : info.high;
        }
    }
}

TEST(Params, AModelHasSomeOfItsOwn) {
    Params params;
    EXPECT_EQ(setParam(params, "density@2", 900.0), "");
    EXPECT_EQ(setParam(params, "youngs_modulus@1", 2e4), "");
    EXPECT_EQ(getParam(params, "density@2"), ParamValue(900.0));
    EXPECT_EQ(getParam(params, "density@1"), ParamValue(std::monostate{}));
    EXPECT_EQ(getParam(params, "density"), getParam(Params{}, "density"));
    EXPECT_EQ(ownNames(params), (std::vector<std::string>{"youngs_modulus@1", "density@2"}));
    EXPECT_EQ(modelOf("density@2"), 2);
    EXPECT_EQ(modelOf("density"), 0);
    EXPECT_FALSE(params == Params{});
    EXPECT_EQ(setParam(params, "density@2", std::monostate{}), "");
    EXPECT_EQ(setParam(params, "youngs_modulus@1", std::monostate{}), "");
    EXPECT_TRUE(params == Params{});
}

TEST(Params, RefusesWhatNoModelHasOfItsOwn) {
    Params params;
    for (const char* name : {"friction@1", "density@0", "density@", "density@01", "density@64",
                             "density@-1", "density@1x", "@1"}) {
        EXPECT_THAT(setParam(params, name, 900.0), HasSubstr("there is no parameter")) << name;
        EXPECT_EQ(findParam(name), nullptr) << name;
    }
    EXPECT_THAT(setParam(params, "density@1", 1.0), HasSubstr("must lie between"));
    EXPECT_THAT(setParam(params, "density@1", Vec3(1, 2, 3)), HasSubstr("or none"));
    EXPECT_TRUE(params == Params{});
}

TEST(Params, EveryRowSetsItsOwnMember) {
    for (const ParamInfo& info : paramTable()) {
        const ParamValue value = anotherValue(info);
        Params params;
        EXPECT_EQ(setParam(params, info.name, value), "") << info.name;
        EXPECT_TRUE(getParam(params, info.name) == value) << info.name;
        EXPECT_FALSE(params == Params{}) << info.name;
    }
}

TEST(Params, FloorMayBeAbsent) {
    Params params;
    EXPECT_EQ(setParam(params, "floor", std::monostate{}), "");
    EXPECT_FALSE(params.floor.has_value());
    EXPECT_TRUE(std::holds_alternative<std::monostate>(getParam(params, "floor")));
}

TEST(Params, IterationsMayBeAWord) {
    Params params;
    EXPECT_EQ(setParam(params, "iterations", std::string("auto")), "");
    EXPECT_EQ(params.iterations, kAutoIterations);
    EXPECT_EQ(getParam(params, "iterations"), ParamValue(std::string("auto")));
    EXPECT_TRUE(params == Params{});
    EXPECT_EQ(setParam(params, "iterations", 7.0), "");
    EXPECT_EQ(getParam(params, "iterations"), ParamValue(7.0));
    EXPECT_THAT(setParam(params, "iterations", std::string("many")), HasSubstr("or \"auto\""));
    EXPECT_THAT(setParam(params, "iterations", 0.0), HasSubstr("between 1 and 60"));
    EXPECT_EQ(params.iterations, 7);
}

TEST(Params, ANewSceneHasATrueModulusAutoIterationsAndGradedWalls) {
    Params params;
    params.density = 900;
    const Params begun = ofNewScene(params);
    EXPECT_EQ(begun.iterations, kAutoIterations);
    EXPECT_EQ(begun.sleeps, 1);
    EXPECT_EQ(begun.wallCoarsening, 3);
    EXPECT_EQ(begun.density, 900);
    EXPECT_EQ(Params{}.sleeps, 0) << "what a session leaves out";
}

struct BadValue {
    const char* name;
    ParamValue value;
    const char* says;
};

TEST(Params, MistakesGiveASentenceAndChangeNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const BadValue cases[] = {
        {"colour", 1.0, "no parameter \"colour\"; known are time_step"},
        {"time_step", 3.0, "between 0.0005 and 0.02 s, not 3"},
        {"time_step", nan, "finite"},
        {"time_step", Vec3(0, 0, 0), "one number"},
        {"time_step", std::monostate{}, "one number"},
        {"iterations", 2.5, "whole number"},
        {"iterations", 0.0, "between 1 and 60, not 0"},
        {"gravity", -9.81, "three numbers"},
        {"gravity", Vec3(0, infinity, 0), "finite"},
        {"gravity", Vec3(0, -101, 0), "between -100 and 100 m/s^2"},
        {"floor", Vec3(0, 0, 0), "or none"},
        {"floor", infinity, "finite"},
        {"solver", 1.0, "must be one of implicit, pbd"},
        {"solver", std::string("fem"), "must be one of implicit, pbd"},
    };
    for (const BadValue& bad : cases) {
        Params params;
        EXPECT_THAT(setParam(params, bad.name, bad.value), HasSubstr(bad.says)) << bad.name;
        EXPECT_TRUE(params == Params{}) << bad.name;
    }
}

TEST(Params, TakeTheFormerSolverForTheImplicitOne) {
    Params params;
    params.solver = SolverMode::pbd;
    EXPECT_EQ(setParam(params, "solver", std::string(kFormerSolver)), "");
    EXPECT_EQ(params.solver, SolverMode::implicit);
}

}  // namespace
}  // namespace kerf
