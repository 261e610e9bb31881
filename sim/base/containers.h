#pragma once

#include <bit>
#include <type_traits>

namespace kerf {

/// Sorts with one bit for each possible number, without duplicates. Returns false, with nothing
/// done, if the numbers are too far apart for that to be fast.
inline bool sortUniqueByBits(std::vector<int>& numbers) {
    constexpr std::size_t kBits = 64;
    constexpr std::size_t kMostWordsPerNumber = 8;
    const auto [least, most] = std::ranges::minmax(numbers);
    const auto placeOf = [low = static_cast<std::size_t>(least)](int number) {
        return static_cast<std::size_t>(number) - low;
    };
    const std::size_t words = placeOf(most) / kBits + 1;
    if (words > kMostWordsPerNumber * numbers.size()) {
        return false;
    }
    std::vector<std::uint64_t> there(words, 0);
    for (const int number : numbers) {
        const std::size_t place = placeOf(number);
        there[place / kBits] |= std::uint64_t{1} << (place % kBits);
    }
    auto next = numbers.begin();
    for (std::size_t word = 0; word < words; ++word) {
        for (std::uint64_t left = there[word]; left != 0; left &= left - 1) {
            *next++ = least + static_cast<int>(word * kBits) + std::countr_zero(left);
        }
    }
    numbers.erase(next, numbers.end());
    return true;
}

/// Ascending, each once.
template <class Value>
void sortUnique(std::vector<Value>& values) {
    if (!std::is_sorted(values.begin(), values.end())) {
        if constexpr (std::is_same_v<Value, int>) {
            if (sortUniqueByBits(values)) {
                return;
            }
        }
        std::sort(values.begin(), values.end());
    }
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// What `f`, a function or a member, gives for each item, in their order.
template <class Items, class F>
auto mapped(const Items& items, F f) {
    std::vector<std::decay_t<decltype(std::invoke(f, *items.begin()))>> results;
    results.reserve(items.size());
    for (const auto& item : items) {
        results.push_back(std::invoke(f, item));
    }
    return results;
}

/// How much capacity to reserve where cuts will add elements: growing later would move all of them
/// in the middle of a stroke. Unused capacity takes no memory in large bodies.
inline std::size_t withGrowthRoom(std::size_t count) {
    return 2 * count;
}

}  // namespace kerf
