#include "tests/support/reference/reference_constraints.h"

#include <gtest/gtest.h>

#include "tests/support/shaken_state.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

/// The gradient of each constraint against central differences of its value.
template <class Constraint>
void expectGradients(const std::vector<Constraint>& constraints, const BodyModel& model) {
    const double step = 1e-6;
    const unsigned seed = 3;
    ReferenceState state = test::shakenState(model, seed, 0.02, 1e-9);
    for (const Constraint& constraint : constraints) {
        const auto exact = linearize(constraint, state);
        ASSERT_TRUE(exact.valid);
        if (std::abs(exact.value) >= shared::kMaxBendError) {
            continue;
        }
        for (std::size_t k = 0; k < exact.vertices.size(); ++k) {
            for (int axis = 0; axis < 3; ++axis) {
                double& x = state.displacements[exact.vertices[k]][axis];
                const double x0 = x;
                x = x0 + step;
                const double forward = linearize(constraint, state).value;
                x = x0 - step;
                const double back = linearize(constraint, state).value;
                x = x0;
                EXPECT_NEAR(exact.gradient[k][axis], (forward - back) / (2 * step), 1e-6)
                    << "seed " << seed;
            }
        }
    }
}

TEST(ReferenceConstraints, GradientsAgreeWithFiniteDifferences) {
    const BodyModel model = buildBodyModel(test::icosphere(1));
    expectGradients(model.edges, model);
    expectGradients(model.bends, model);
    expectGradients(model.ispcs, model);
}

TEST(ReferenceConstraints, AreZeroAtRest) {
    const BodyModel model = buildBodyModel(test::bentTube());
    const ReferenceState rest = restState(model);
    for (const auto& c : model.edges) {
        EXPECT_NEAR(linearize(c, rest).value, 0, 1e-6);
    }
    for (const auto& c : model.bends) {
        EXPECT_NEAR(linearize(c, rest).value, 0, 1e-5);
    }
    for (const auto& c : model.ispcs) {
        EXPECT_NEAR(linearize(c, rest).value, 0, 1e-6);
    }
}

TEST(ReferenceConstraints, ABendIsClamped) {
    const BodyModel model = buildBodyModel(test::icosphere(1));
    ReferenceState state = restState(model);
    for (Vec3& p : state.positions) {
        p.y() *= 0.01;
    }
    double largest = 0;
    for (const auto& c : model.bends) {
        largest = std::max(largest, std::abs(linearize(c, state).value));
    }
    EXPECT_FLOAT_EQ(largest, shared::kMaxBendError);
}

TEST(ReferenceConstraints, PointsThatCoincideHaveNoGradient) {
    const BodyModel model = buildBodyModel(test::box());
    ReferenceState state = restState(model);
    std::ranges::fill(state.positions, Vec3(1, 2, 3));
    EXPECT_FALSE(linearize(model.edges[0], state).valid);
    EXPECT_FALSE(linearize(model.bends[0], state).valid);
    EXPECT_FALSE(linearize(model.ispcs[0], state).valid);
}

}  // namespace
}  // namespace kerf
