#include <gtest/gtest.h>

#include <climits>
#include <random>

#include "sim/base/containers.h"

namespace kerf {
namespace {

// Dense numbers, and such as lie far apart.
TEST(SortUnique, LeavesEachNumberOnceInOrder) {
    constexpr unsigned kSeed = 11;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    std::mt19937 random{kSeed};
    for (const int count : {0, 1, 2, 63, 64, 65, 1000}) {
        for (const int gap : {1, 3, 100, 5000}) {
            std::vector<int> numbers(count);
            int next = static_cast<int>(random() % 1000) - 500;
            for (int& number : numbers) {
                number = next;
                next += 1 + static_cast<int>(random() % gap);
            }
            const std::vector<int> sorted = numbers;
            numbers.insert(numbers.end(), sorted.begin(), sorted.begin() + count / 2);
            std::ranges::shuffle(numbers, random);
            sortUnique(numbers);
            EXPECT_EQ(numbers, sorted) << count << " numbers up to " << gap << " apart";
        }
    }
    std::vector<int> far{INT_MAX, 0, INT_MIN, 0};
    sortUnique(far);
    EXPECT_EQ(far, (std::vector<int>{INT_MIN, 0, INT_MAX}));
}

}  // namespace
}  // namespace kerf
