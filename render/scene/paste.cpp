#include "render/scene/paste.h"

#include <algorithm>
#include <cstddef>

namespace kerf::render {

void paste(Image& target, const Image& picture, int left, int top) {
    const int firstX = std::max(0, -left);
    const int firstY = std::max(0, -top);
    const int endX = std::min(picture.width, target.width - left);
    const int endY = std::min(picture.height, target.height - top);
    const auto placeOf = [](const Image& image, int x, int y) {
        return 4 * (std::ptrdiff_t{y} * image.width + x);
    };
    for (int y = firstY; y < endY && firstX < endX; ++y) {
        std::copy_n(picture.pixels.begin() + placeOf(picture, firstX, y),
                    std::ptrdiff_t{4} * (endX - firstX),
                    target.pixels.begin() + placeOf(target, left + firstX, top + y));
    }
}

}  // namespace kerf::render
