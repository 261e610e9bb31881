#include "render/scene/plane_filter.h"

#include <algorithm>

namespace kerf::render {
namespace {

int radiusOf(const Kernel& kernel) {
    return static_cast<int>(kernel.size() / 2);
}

void addScaled(float* out, const float* in, float weight, int count) {
    for (int x = 0; x < count; ++x) {
        out[x] += weight * in[x];
    }
}

/// A row with `radius` copies of its ends on either side.
void pad(const float* row, int width, int radius, std::vector<float>& padded) {
    padded.assign(std::size_t(width) + 2 * std::size_t(radius), row[0]);
    std::copy(row, row + width, padded.begin() + radius);
    std::fill(padded.end() - radius, padded.end(), row[width - 1]);
}

Plane filteredAlongRows(const Plane& plane, const Kernel& kernel) {
    Plane out(plane.width, plane.height);
    std::vector<float> padded;
    for (int y = 0; y < plane.height; ++y) {
        pad(plane.row(y), plane.width, radiusOf(kernel), padded);
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            addScaled(out.row(y), &padded[k], kernel[k], plane.width);
        }
    }
    return out;
}

Plane filteredAlongColumns(const Plane& plane, const Kernel& kernel) {
    Plane out(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y) {
        for (int k = 0; k < static_cast<int>(kernel.size()); ++k) {
            const int from = std::clamp(y + k - radiusOf(kernel), 0, plane.height - 1);
            addScaled(out.row(y), plane.row(from), kernel[k], plane.width);
        }
    }
    return out;
}

}  // namespace

Plane filtered(const Plane& plane, const Kernel& alongRows, const Kernel& alongColumns) {
    return filteredAlongColumns(filteredAlongRows(plane, alongRows), alongColumns);
}

}  // namespace kerf::render
