#include "render/scene/picture_comparison.h"

#include <cstdlib>

#include "render/scene/flip.h"

namespace kerf::render {
namespace {

using Rgb = std::array<float, 3>;

constexpr std::uint8_t kBlack = 0;
constexpr std::uint8_t kWhite = 255;
constexpr std::uint8_t kMaskGrey = 128;
constexpr int kVisibleStep = 2;  // of a channel, of 255

bool isOpaque(const Image& image) {
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
        if (image.pixels[i] != 255) {
            return false;
        }
    }
    return true;
}

/// The part of `rect` in a picture.
PixelRect clipped(const PixelRect& rect, const Image& image) {
    const int left = std::clamp(rect.x, 0, image.width);
    const int top = std::clamp(rect.y, 0, image.height);
    const long right = std::clamp<long>(long(rect.x) + rect.width, left, image.width);
    const long bottom = std::clamp<long>(long(rect.y) + rect.height, top, image.height);
    return {left, top, static_cast<int>(right) - left, static_cast<int>(bottom) - top};
}

/// Calls `visit` with the index of each pixel of the masks, with some more than once.
template <class Visit>
void visitMasked(const Image& image, const std::vector<PixelRect>& masks, Visit visit) {
    for (const PixelRect& mask : masks) {
        const PixelRect part = clipped(mask, image);
        for (int y = part.y; y < part.y + part.height; ++y) {
            for (int x = part.x; x < part.x + part.width; ++x) {
                visit(std::size_t(y) * image.width + x);
            }
        }
    }
}

/// The picture with one colour in all masks, so that what lies there has no effect on what is
/// beside them.
Image maskedOut(Image image, const std::vector<PixelRect>& masks) {
    visitMasked(image, masks, [&](std::size_t pixel) {
        std::fill_n(&image.pixels[4 * pixel], 3, kMaskGrey);
        image.pixels[4 * pixel + 3] = 255;
    });
    return image;
}

std::uint8_t blended(int color, int ground, int alpha) {
    return static_cast<std::uint8_t>((color * alpha + ground * (255 - alpha) + 127) / 255);
}

/// The picture as it is shown on a ground.
Image seenOver(Image image, std::uint8_t ground) {
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        for (std::size_t c = i; c < i + 3; ++c) {
            image.pixels[c] = blended(image.pixels[c], ground, image.pixels[i + 3]);
        }
        image.pixels[i + 3] = 255;
    }
    return image;
}

std::vector<float> errorsOnAnyGround(const Image& a, const Image& b) {
    if (isOpaque(a) && isOpaque(b)) {
        return flipErrors(a, b);
    }
    std::vector<float> errors = flipErrors(seenOver(a, kBlack), seenOver(b, kBlack));
    const std::vector<float> onWhite = flipErrors(seenOver(a, kWhite), seenOver(b, kWhite));
    for (std::size_t i = 0; i < errors.size(); ++i) {
        errors[i] = std::max(errors[i], onWhite[i]);
    }
    return errors;
}

bool haveOneSize(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height;
}

long pixelsOfLarger(const Image& a, const Image& b) {
    return std::max(long(a.width) * a.height, long(b.width) * b.height);
}

long countUnmasked(const Image& image, const std::vector<PixelRect>& masks) {
    std::vector<bool> masked(std::size_t(image.width) * image.height);
    visitMasked(image, masks, [&](std::size_t pixel) { masked[pixel] = true; });
    return std::count(masked.begin(), masked.end(), false);
}

/// Looks for the square with the largest mean, row by row of squares.
class WorstPlaceSearch {
  public:
    WorstPlaceSearch(const std::vector<float>& errors, int width, int height)
        : errors_(errors),
          width_(width),
          height_(height),
          columns_(std::min(kPlaceSide, width)),
          rows_(std::min(kPlaceSide, height)),
          sums_(width, 0.0) {}

    void run(PictureComparison& result) {
        for (int y = 0; y < height_; ++y) {
            addRow(y, 1);
            if (y >= rows_) {
                addRow(y - rows_, -1);
            }
            if (y >= rows_ - 1) {
                searchRow(y - rows_ + 1, result);
            }
        }
    }

  private:
    void addRow(int y, double factor) {
        for (int x = 0; x < width_; ++x) {
            sums_[x] += factor * errors_[std::size_t(y) * width_ + x];
        }
    }

    void searchRow(int top, PictureComparison& result) const {
        double sum = 0;
        for (int x = 0; x < width_; ++x) {
            sum += sums_[x] - (x >= columns_ ? sums_[x - columns_] : 0);
            const double mean = sum / (columns_ * rows_);
            if (x >= columns_ - 1 && mean > result.worst) {
                result.worst = mean;
                result.worstPlace = {x - columns_ + 1, top, columns_, rows_};
            }
        }
    }

    const std::vector<float>& errors_;
    int width_;
    int height_;
    int columns_;  // of a square
    int rows_;
    std::vector<double> sums_;  // over the rows of a square, by column
};

/// Adds what one pixel differs by to `difference`, with the mean as a sum of bytes.
void addPixel(const std::uint8_t* a, const std::uint8_t* b, ChannelDifference& difference) {
    int largest = 0;
    for (int c = 0; c < 4; ++c) {
        const int step = std::abs(int(a[c]) - int(b[c]));
        difference.mean += step;
        largest = std::max(largest, step);
    }
    difference.largest = std::max(difference.largest, largest / 255.0);
    difference.pixels += largest > kVisibleStep ? 1 : 0;
}

void summarize(const Image& image, PictureComparison& comparison) {
    double sum = 0;
    for (const float error : comparison.errors) {
        sum += error;
        comparison.pixelsDiffering += error > kVisibleError ? 1 : 0;
    }
    comparison.mean = sum / double(std::max(comparison.pixelsCompared, 1L));
    WorstPlaceSearch(comparison.errors, image.width, image.height).run(comparison);
}

PictureComparison ofDifferentSizes(const Image& a, const Image& b) {
    PictureComparison result;
    result.pixelsCompared = result.pixelsDiffering = pixelsOfLarger(a, b);
    result.mean = result.worst = 1;
    return result;
}

/// Red, orange, yellow: grows brighter all along.
Rgb glow(float error) {
    const float t = std::sqrt(error);
    return {std::min(1.0F, 0.45F + 0.9F * t), std::max(0.0F, 1.6F * t - 0.6F),
            std::max(0.55F * (1 - 1.6F * t), 0.9F * (t - 0.7F))};
}

void paint(std::uint8_t* pixel, const Rgb& color) {
    for (int c = 0; c < 3; ++c) {
        pixel[c] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[c], 0.0F, 1.0F)));
    }
    pixel[3] = 255;
}

float dimmedGrey(const std::uint8_t* pixel) {
    const float luma = 0.30F * pixel[0] + 0.59F * pixel[1] + 0.11F * pixel[2];
    return 0.05F + 0.4F * luma / 255;
}

Rgb mixed(const Rgb& a, const Rgb& b, float share) {
    Rgb color{};
    for (int c = 0; c < 3; ++c) {
        color[c] = a[c] + share * (b[c] - a[c]);
    }
    return color;
}

/// What is hardly visible is hardly coloured.
void paintErrors(const std::vector<float>& errors, Image& picture) {
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const float grey = dimmedGrey(&picture.pixels[4 * i]);
        const float share = std::min(errors[i] / kVisibleError, 1.0F);
        paint(&picture.pixels[4 * i], mixed({grey, grey, grey}, glow(errors[i]), share * share));
    }
}

void paintMasks(const std::vector<PixelRect>& masks, Image& picture) {
    constexpr int kStripe = 4;
    visitMasked(picture, masks, [&](std::size_t pixel) {
        const std::size_t diagonal = pixel % picture.width + pixel / picture.width;
        const bool dark = diagonal / kStripe % 2 == 0;
        paint(&picture.pixels[4 * pixel], dark ? Rgb{0.05F, 0.1F, 0.25F} : Rgb{0.1F, 0.2F, 0.4F});
    });
}

/// A line of one pixel around `inside`, some pixels away, as far as it lies in the picture.
void paintFrame(const PixelRect& inside, Image& picture) {
    constexpr int kGap = 6;
    const PixelRect outer = {inside.x - kGap, inside.y - kGap, inside.width + 2 * kGap,
                             inside.height + 2 * kGap};
    const std::vector<PixelRect> lines = {{outer.x, outer.y, outer.width, 1},
                                          {outer.x, outer.y + outer.height - 1, outer.width, 1},
                                          {outer.x, outer.y, 1, outer.height},
                                          {outer.x + outer.width - 1, outer.y, 1, outer.height}};
    visitMasked(picture, lines, [&](std::size_t pixel) {
        paint(&picture.pixels[4 * pixel], {0, 0.9F, 0.9F});
    });
}

}  // namespace

double PictureComparison::shareDiffering() const {
    return pixelsCompared == 0 ? 0 : double(pixelsDiffering) / double(pixelsCompared);
}

PictureComparison comparePictures(const Image& a, const Image& b,
                                  const ComparisonOptions& options) {
    if (!haveOneSize(a, b)) {
        return ofDifferentSizes(a, b);
    }
    const Image first = maskedOut(a, options.masks);
    const Image second = maskedOut(b, options.masks);
    PictureComparison result;
    result.sameSize = true;
    result.identical = first.pixels == second.pixels;
    result.pixelsCompared = countUnmasked(a, options.masks);
    result.errors = errorsOnAnyGround(first, second);
    visitMasked(a, options.masks, [&](std::size_t pixel) { result.errors[pixel] = 0; });
    summarize(a, result);
    return result;
}

bool withinLimits(const PictureComparison& comparison, const PictureLimits& limits) {
    return comparison.sameSize && comparison.shareDiffering() <= limits.pixels &&
           comparison.worst <= limits.worst;
}

Image differencePicture(const Image& a, const PictureComparison& comparison,
                        const ComparisonOptions& options) {
    if (!comparison.sameSize) {
        return {};
    }
    Image picture = seenOver(a, kWhite);
    paintErrors(comparison.errors, picture);
    paintMasks(options.masks, picture);
    if (comparison.worst > 0) {
        paintFrame(comparison.worstPlace, picture);
    }
    return picture;
}

ChannelDifference channelDifference(const Image& a, const Image& b,
                                    const ComparisonOptions& options) {
    if (!haveOneSize(a, b)) {
        return {1, 1, pixelsOfLarger(a, b)};
    }
    const Image first = maskedOut(a, options.masks);
    const Image second = maskedOut(b, options.masks);
    ChannelDifference result;
    for (std::size_t i = 0; i < first.pixels.size(); i += 4) {
        addPixel(&first.pixels[i], &second.pixels[i], result);
    }
    const long compared = std::max(countUnmasked(a, options.masks), 1L);
    result.mean /= 4 * 255.0 * double(compared);
    return result;
}

}  // namespace kerf::render
