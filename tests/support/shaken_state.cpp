#include "tests/support/shaken_state.h"

#include <random>

namespace kerf::test {

ReferenceState shakenState(const BodyModel& model, unsigned seed, double offset,
                           double displacement) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-1, 1);
    const auto vector = [&] {
        const double x = noise(random);
        const double y = noise(random);
        return Vec3(x, y, noise(random));
    };
    ReferenceState state = restState(model);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        state.positions[v] += offset * vector();
        state.displacements[v] = displacement * vector();
    }
    return state;
}

}  // namespace kerf::test
