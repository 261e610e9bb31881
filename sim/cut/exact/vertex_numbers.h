#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kerf::cut {

/// Numbers of some of the vertices of a mesh.
class VertexNumbers {
  public:
    /// With room for so many.
    explicit VertexNumbers(std::size_t most = 8) : places_(std::bit_ceil(2 * most + 1)) {}

    /// -1 for a vertex without one.
    int find(int vertex) const { return places_[placeFor(vertex)].number; }
    /// Of a vertex without one; `number` >= 0.
    void add(int vertex, int number) {
        if (2 * ++count_ > places_.size()) {
            grow();
        }
        places_[placeFor(vertex)] = {vertex, number};
    }
    std::size_t size() const { return count_; }

  private:
    struct Place {
        int vertex = -1;
        int number = -1;
    };

    /// Where it is, or where it would go.
    std::size_t placeFor(int vertex) const {
        const std::size_t mask = places_.size() - 1;
        std::size_t at = static_cast<std::uint64_t>(vertex) * 0x9E3779B97F4A7C15ull >> 32 & mask;
        while (places_[at].vertex >= 0 && places_[at].vertex != vertex) {
            at = (at + 1) & mask;
        }
        return at;
    }

    void grow() {
        const std::vector<Place> before =
            std::exchange(places_, std::vector<Place>(4 * places_.size()));
        for (const Place& place : before) {
            if (place.vertex >= 0) {
                places_[placeFor(place.vertex)] = place;
            }
        }
    }

    std::vector<Place> places_;  ///< a power of two of them, half empty at least
    std::size_t count_ = 0;
};

}  // namespace kerf::cut
