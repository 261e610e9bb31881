#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/body/body_model.h"

namespace kerf {

/// The vertices of an entry of BodyModel::triangles.
inline std::array<std::uint32_t, 3> verticesOf(const std::array<std::uint32_t, 4>& triangle) {
    return {triangle[0], triangle[1], triangle[2]};
}

/// The room that a list of `count` entries gets, with some to spare.
inline std::uint32_t incidenceRoom(std::uint32_t count) {
    constexpr std::uint32_t kStep = 4;
    return (count + kStep - 1) / kStep * kStep;
}

/// The elements that touch each vertex, ascending by element and slot (a counting sort).
template <class Element>
Incidence buildIncidence(const std::vector<Element>& elements, std::size_t vertexCount) {
    Incidence incidence;
    incidence.ranges.assign(vertexCount, {});
    for (const Element& element : elements) {
        for (const std::uint32_t v : verticesOf(element)) {
            ++incidence.ranges[v].end;
        }
    }
    std::uint32_t first = 0;
    for (IncidenceRange& range : incidence.ranges) {
        const std::uint32_t room = incidenceRoom(range.end);
        range = {first, first};
        first += room;
    }
    incidence.entries.resize(first);
    for (std::size_t e = 0; e < elements.size(); ++e) {
        std::uint32_t slot = 0;
        for (const std::uint32_t v : verticesOf(elements[e])) {
            incidence.entries[incidence.ranges[v].end++] =
                static_cast<std::uint32_t>(4 * e) + slot++;
        }
    }
    return incidence;
}

/// Number of elements that touch vertex v.
inline std::uint32_t valence(const Incidence& incidence, std::size_t v) {
    return incidence.ranges[v].end - incidence.ranges[v].first;
}

}  // namespace kerf
