#pragma once

#include <cstddef>
#include <vector>

namespace kerf::render {

/// One number per pixel, top row first.
struct Plane {
    Plane() = default;
    Plane(int columns, int rows)
        : width(columns), height(rows), values(std::size_t(columns) * rows) {}
    float* row(int y) { return &values[std::size_t(y) * width]; }
    const float* row(int y) const { return &values[std::size_t(y) * width]; }

    int width = 0;
    int height = 0;
    std::vector<float> values;
};

/// The weights of a filter along one axis: an odd number, the middle one for the pixel itself.
using Kernel = std::vector<float>;

/// Filters along the rows, then along the columns. The pixels at the border are repeated beyond it.
Plane filtered(const Plane& plane, const Kernel& alongRows, const Kernel& alongColumns);

}  // namespace kerf::render
