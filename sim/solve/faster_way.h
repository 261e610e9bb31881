#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace kerf {

/// The choice between two ways to the same result: the one that took less time when it was last
/// taken. Each is tried twice first, since the first time compiles its kernels; and now and then it
/// is the other's turn, since what makes them fast or slow may change.
class FasterWay {
  public:
    /// 0 or 1.
    std::size_t next() const {
        for (const std::size_t way : {std::size_t{0}, std::size_t{1}}) {
            if (tries_[way] < kTries) {
                return way;
            }
        }
        const std::size_t faster = last_[1] < last_[0] ? 1 : 0;
        return sinceOther_ < kOtherAfter ? faster : 1 - faster;
    }

    /// How long next() took, in any unit.
    void took(double time) {
        const std::size_t way = next();
        sinceOther_ = sinceOther_ < kOtherAfter ? sinceOther_ + 1 : 0;
        tries_[way] = std::min(tries_[way] + 1, kTries);
        last_[way] = time;
    }

    static constexpr int kTries = 2;
    static constexpr int kOtherAfter = 60;

  private:
    std::array<double, 2> last_{};
    std::array<int, 2> tries_{};
    int sinceOther_ = 0;
};

}  // namespace kerf
