#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace kerf {

/// Sorts numbers of which none is there twice: by one bit each where they lie dense enough, which
/// takes a fraction of the time that comparing them does. Keeps its room for the next ones.
class DistinctSorter {
  public:
    void sort(std::vector<int>& numbers) {
        if (numbers.empty()) {
            return;
        }
        const auto [least, most] = std::ranges::minmax(numbers);
        const auto words = (static_cast<std::size_t>(most) - least) / kBits + 1;
        if (words > kMostWordsPerNumber * numbers.size()) {
            std::ranges::sort(numbers);
            return;
        }
        bits_.assign(words, 0);
        for (const int number : numbers) {
            const auto place = static_cast<std::size_t>(number - least);
            bits_[place / kBits] |= std::uint64_t{1} << (place % kBits);
        }
        auto next = numbers.begin();
        for (std::size_t word = 0; word < words; ++word) {
            for (std::uint64_t left = bits_[word]; left != 0; left &= left - 1) {
                *next++ = least + static_cast<int>(word * kBits) + std::countr_zero(left);
            }
        }
    }

  private:
    static constexpr std::size_t kBits = 64;
    static constexpr std::size_t kMostWordsPerNumber = 8;

    std::vector<std::uint64_t> bits_;
};

}  // namespace kerf
