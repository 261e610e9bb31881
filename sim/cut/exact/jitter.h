#pragma once

#include "sim/base/math.h"

namespace kerf::cut {

/// Reproducible pseudo-random numbers (xorshift64) for the blade's offset.
class Jitter {
  public:
    /// Starts the sequence of `seed`.
    explicit Jitter(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ull + 1) {
        for (int i = 0; i < 5; ++i) {
            next();
        }
    }

    /// The next number, uniform in [0, 1).
    double uniform() { return static_cast<double>(next() >> 11) * (1.0 / 9007199254740992.0); }
    /// The next number, uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// A random unit vector, uniform over all directions.
    Vec3 direction() {
        while (true) {
            const double x = uniform(-1, 1);
            const double y = uniform(-1, 1);
            const double z = uniform(-1, 1);
            const Vec3 candidate(x, y, z);
            const double length = candidate.norm();
            if (length > 0.1 && length < 1) {
                return candidate / length;
            }
        }
    }

  private:
    std::uint64_t next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return state_;
    }

    std::uint64_t state_;
};

}  // namespace kerf::cut
