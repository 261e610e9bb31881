#include "render/scene/flip.h"

#include <Eigen/Core>
#include <Eigen/LU>

namespace kerf::render {

namespace {

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

/// Filters along the rows, then along the columns. The pixels at the border are repeated beyond it.
Plane filtered(const Plane& plane, const Kernel& alongRows, const Kernel& alongColumns) {
    return filteredAlongColumns(filteredAlongRows(plane, alongRows), alongColumns);
}

using Eigen::Matrix3f;
using Eigen::Vector3f;
using Planes = std::array<Plane, 3>;

constexpr float kPixelsPerDegree = 67;
// Exponent of colour differences, and how they are spread: those up to kKnee of the largest one
// take kKneeError of the range.
constexpr float kColorExponent = 0.7F;
constexpr float kKnee = 0.4F;
constexpr float kKneeError = 0.95F;
constexpr float kFeatureDegrees = 0.082F;  // width of an edge that the eye finds
constexpr int kBandRows = 128;             // compared at once, so that planes stay in the cache
constexpr int kReach = 10;                 // of the widest filter [pixels]

/// A term of a contrast sensitivity, in space: height * sqrt(pi / spread) * exp(-pi^2 x^2 / spread)
/// at x degrees.
struct Sensitivity {
    double height;
    double spread;  // [degrees^2]
};
constexpr Sensitivity kAchromatic{1, 0.0047};
constexpr Sensitivity kRedGreen{1, 0.0053};
constexpr Sensitivity kBlueYellow{34.1, 0.04};
constexpr Sensitivity kBlueYellowNarrow{13.5, 0.025};

/// Weights that sum up to 1, and the sum that they had.
struct Gaussian {
    Kernel weights;
    double sum = 0;
};

Gaussian gaussian(double sigma) {
    Gaussian result;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    for (int x = -radius; x <= radius; ++x) {
        const double weight = std::exp(-x * x / (2 * sigma * sigma));
        result.weights.push_back(static_cast<float>(weight));
        result.sum += weight;
    }
    for (float& weight : result.weights) {
        weight /= static_cast<float>(result.sum);
    }
    return result;
}

Gaussian gaussian(const Sensitivity& term) {
    return gaussian(kPixelsPerDegree * std::sqrt(term.spread / 2) / std::numbers::pi);
}

/// The share of a term in a filter of two dimensions.
double volumeOf(const Sensitivity& term) {
    const double sum = gaussian(term).sum;
    return term.height * std::sqrt(std::numbers::pi / term.spread) * sum * sum;
}

/// Scales what is positive to a sum of 1, and what is negative to one of -1.
void balance(Kernel& kernel) {
    float positive = 0;
    float negative = 0;
    for (const float weight : kernel) {
        (weight > 0 ? positive : negative) += weight;
    }
    for (float& weight : kernel) {
        weight /= weight > 0 ? positive : -negative;
    }
}

/// Smoothing, first and second derivative: what finds edges and points.
struct FeatureKernels {
    Kernel smooth;
    Kernel edge;
    Kernel point;
};

FeatureKernels featureKernels() {
    const float sigma = 0.5F * kFeatureDegrees * kPixelsPerDegree;
    FeatureKernels kernels;
    kernels.smooth = kernels.edge = kernels.point = gaussian(sigma).weights;
    const int radius = static_cast<int>(kernels.smooth.size() / 2);
    for (int x = -radius; x <= radius; ++x) {
        const float place = static_cast<float>(x) / sigma;
        kernels.edge[x + radius] *= -place;
        kernels.point[x + radius] *= place * place - 1;
    }
    balance(kernels.edge);
    balance(kernels.point);
    return kernels;
}

/// Light of a byte of a picture (IEC 61966-2-1), 0 to 1.
float lightOf(std::uint8_t byte) {
    static const std::array<float, 256> kLight = [] {
        std::array<float, 256> light{};
        for (std::size_t i = 0; i < light.size(); ++i) {
            const double value = double(i) / 255;
            light[i] = static_cast<float>(
                value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
        }
        return light;
    }();
    return kLight[byte];
}

/// From linear sRGB to CIE XYZ, each divided by that of white (D65).
const Matrix3f& xyzOfRgb() {
    static const Matrix3f kMatrix = [] {
        Matrix3f matrix;
        matrix << 0.4124564F, 0.3575761F, 0.1804375F, 0.2126729F, 0.7151522F, 0.0721750F,
            0.0193339F, 0.1191920F, 0.9503041F;
        const Vector3f white = matrix.rowwise().sum();
        return Matrix3f(white.cwiseInverse().asDiagonal() * matrix);
    }();
    return kMatrix;
}

const Matrix3f& rgbOfXyz() {
    static const Matrix3f kMatrix = xyzOfRgb().inverse();
    return kMatrix;
}

/// Achromatic, red to green, blue to yellow: YCxCz, a linear kin of CIELAB.
Vector3f opponentOfXyz(const Vector3f& xyz) {
    return {116 * xyz.y() - 16, 500 * (xyz.x() - xyz.y()), 200 * (xyz.y() - xyz.z())};
}

Vector3f xyzOfOpponent(const Vector3f& color) {
    const float y = (color.x() + 16) / 116;
    return {y + color.y() / 500, y, y - color.z() / 200};
}

/// The non-linear response of CIELAB.
float response(float t) {
    constexpr float kBend = 6.0F / 29;
    return t > kBend * kBend * kBend ? std::cbrt(t) : t / (3 * kBend * kBend) + 4.0F / 29;
}

/// CIELAB in which, as Hunt found, what is brighter is more colourful.
Vector3f huntLabOfXyz(const Vector3f& xyz) {
    const Vector3f r = xyz.unaryExpr(&response);
    const float lightness = 116 * r.y() - 16;
    const float hunt = 0.01F * lightness;
    return {lightness, hunt * 500 * (r.x() - r.y()), hunt * 200 * (r.y() - r.z())};
}

/// The distance HyAB, which holds for large differences too.
float distance(const Vector3f& a, const Vector3f& b) {
    return std::abs(a.x() - b.x()) + (a - b).tail<2>().norm();
}

/// Rows of a picture, the last one not included.
struct Rows {
    int first = 0;
    int last = 0;
    int count() const { return last - first; }
};

Planes opponentPlanes(const Image& image, const Rows& rows) {
    Planes planes;
    planes.fill(Plane(image.width, rows.count()));
    const std::uint8_t* pixel = &image.pixels[std::size_t(4) * rows.first * image.width];
    for (std::size_t i = 0; i < planes[0].values.size(); ++i, pixel += 4) {
        const Vector3f rgb(lightOf(pixel[0]), lightOf(pixel[1]), lightOf(pixel[2]));
        const Vector3f color = opponentOfXyz(xyzOfRgb() * rgb);
        for (int c = 0; c < 3; ++c) {
            planes[c].values[i] = color[c];
        }
    }
    return planes;
}

/// The blue-yellow channel as far as the eye resolves it.
Plane blurredBlueYellow(const Plane& plane) {
    static const Kernel kWide = gaussian(kBlueYellow).weights;
    static const Kernel kNarrow = gaussian(kBlueYellowNarrow).weights;
    static const float kShare = static_cast<float>(
        volumeOf(kBlueYellow) / (volumeOf(kBlueYellow) + volumeOf(kBlueYellowNarrow)));
    Plane blurred = filtered(plane, kWide, kWide);
    const Plane narrow = filtered(plane, kNarrow, kNarrow);
    for (std::size_t i = 0; i < blurred.values.size(); ++i) {
        blurred.values[i] = kShare * blurred.values[i] + (1 - kShare) * narrow.values[i];
    }
    return blurred;
}

/// What the eye resolves of the opponent colours.
Planes blurredPlanes(const Planes& opponent) {
    static const Kernel kLuminance = gaussian(kAchromatic).weights;
    static const Kernel kColor = gaussian(kRedGreen).weights;
    return {filtered(opponent[0], kLuminance, kLuminance), filtered(opponent[1], kColor, kColor),
            blurredBlueYellow(opponent[2])};
}

Vector3f colorAt(const Planes& planes, std::size_t pixel) {
    return {planes[0].values[pixel], planes[1].values[pixel], planes[2].values[pixel]};
}

/// The colour that a display can show and that is nearest by channels, as the observer takes it.
Vector3f perceived(const Vector3f& opponent) {
    const Vector3f rgb = rgbOfXyz() * xyzOfOpponent(opponent);
    return huntLabOfXyz(xyzOfRgb() * rgb.cwiseMax(0.0F).cwiseMin(1.0F));
}

/// The length of the gradient that `derivative` finds, in units of the range of luminance.
Plane strength(const Plane& achromatic, const Kernel& derivative, const Kernel& smooth) {
    Plane result = filtered(achromatic, derivative, smooth);
    const Plane down = filtered(achromatic, smooth, derivative);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        result.values[i] = std::hypot(result.values[i], down.values[i]) / 116;
    }
    return result;
}

/// What an observer takes from a picture.
struct Percept {
    Planes colors;  ///< opponent colours, as far as the eye resolves them
    Plane edges;
    Plane points;
};

Percept perceptOf(const Image& image, const Rows& rows) {
    static const FeatureKernels kKernels = featureKernels();
    const Planes opponent = opponentPlanes(image, rows);
    return {blurredPlanes(opponent), strength(opponent[0], kKernels.edge, kKernels.smooth),
            strength(opponent[0], kKernels.point, kKernels.smooth)};
}

/// The largest colour difference of all, that of green and blue, with its exponent.
float largestDifference() {
    static const float kLargest = std::pow(distance(huntLabOfXyz(xyzOfRgb() * Vector3f(0, 1, 0)),
                                                    huntLabOfXyz(xyzOfRgb() * Vector3f(0, 0, 1))),
                                           kColorExponent);
    return kLargest;
}

/// Small differences take most of the range from 0 to 1, large ones the rest.
float spread(float difference) {
    const float share = std::pow(difference, kColorExponent) / largestDifference();
    const float error = share < kKnee
                            ? share * kKneeError / kKnee
                            : kKneeError + (share - kKnee) / (1 - kKnee) * (1 - kKneeError);
    return std::min(error, 1.0F);
}

float colorError(const Percept& a, const Percept& b, std::size_t pixel) {
    const Vector3f first = colorAt(a.colors, pixel);
    const Vector3f second = colorAt(b.colors, pixel);
    return first == second ? 0 : spread(distance(perceived(first), perceived(second)));
}

float featureError(const Percept& a, const Percept& b, std::size_t pixel) {
    const float edge = std::abs(a.edges.values[pixel] - b.edges.values[pixel]);
    const float point = std::abs(a.points.values[pixel] - b.points.values[pixel]);
    return std::sqrt(std::max(edge, point) / std::numbers::sqrt2_v<float>);
}

/// A difference of colours weighs more where an edge or a point is gone or new.
float errorAt(const Percept& a, const Percept& b, std::size_t pixel) {
    const float color = colorError(a, b, pixel);
    return color == 0 ? 0 : std::pow(color, 1 - std::min(featureError(a, b, pixel), 1.0F));
}

bool sameRows(const Image& a, const Image& b, const Rows& rows) {
    const std::size_t bytes = std::size_t(4) * a.width;
    const auto first = a.pixels.begin() + static_cast<std::ptrdiff_t>(bytes * rows.first);
    const auto last = a.pixels.begin() + static_cast<std::ptrdiff_t>(bytes * rows.last);
    return std::equal(first, last, b.pixels.begin() + (first - a.pixels.begin()));
}

/// Writes the errors of `rows` of two pictures that differ there or as near as a filter reaches.
void measureRows(const Image& a, const Image& b, const Rows& rows, std::vector<float>& errors) {
    const Rows read{std::max(rows.first - kReach, 0), std::min(rows.last + kReach, a.height)};
    if (sameRows(a, b, read)) {
        return;
    }
    const Percept first = perceptOf(a, read);
    const Percept second = perceptOf(b, read);
    const std::size_t offset = std::size_t(read.first) * a.width;
    for (std::size_t i = std::size_t(rows.first) * a.width; i < std::size_t(rows.last) * a.width;
         ++i) {
        errors[i] = errorAt(first, second, i - offset);
    }
}

}  // namespace

std::vector<float> flipErrors(const Image& a, const Image& b) {
    std::vector<float> errors(std::size_t(a.width) * a.height, 0);
    for (int row = 0; row < a.height; row += kBandRows) {
        measureRows(a, b, {row, std::min(row + kBandRows, a.height)}, errors);
    }
    return errors;
}

}  // namespace kerf::render
