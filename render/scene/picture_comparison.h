#pragma once

#include "render/scene/image.h"

namespace kerf::render {

/// The error above which a pixel's difference is visible when flipping between two pictures.
inline constexpr float kVisibleError = 0.1F;
/// The side of a place: errors in such a square are seen as one [pixels].
inline constexpr int kPlaceSide = 12;

/// Options for comparing two pictures.
struct ComparisonOptions {
    std::vector<PixelRect> masks;  ///< areas to ignore; they may overlap
};

/// The perceived difference of two pictures. Errors are those of `flipErrors`, from 0 to 1.
struct PictureComparison {
    bool sameSize = false;
    bool identical = false;  ///< the same bytes outside the masks
    /// By pixel, 0 in masks; empty where the sizes differ.
    std::vector<float> errors;
    long pixelsCompared = 0;   ///< those outside the masks
    long pixelsDiffering = 0;  ///< with an error above kVisibleError
    double mean = 0;           ///< of the errors of the pixels compared
    double worst = 0;          ///< largest mean error of a square of kPlaceSide pixels
    PixelRect worstPlace;      ///< that square; empty for no difference

    /// pixelsDiffering as a share of those compared.
    double shareDiffering() const;
};

/// Compares two pictures perceptually. Transparent pixels are compared over black and over white,
/// and the larger error counts. Pictures of different sizes differ in all pixels of the larger one,
/// with mean and worst 1.
PictureComparison comparePictures(const Image& a, const Image& b,
                                  const ComparisonOptions& options = {});

/// Limits within which two pictures count as equal.
struct PictureLimits {
    double pixels = 0;  ///< of PictureComparison::shareDiffering
    double worst = 0;   ///< of PictureComparison::worst
};

/// For pictures of one driver, or of the same bodies drawn by another: noise of one grey level is
/// no difference, a piece that moved by two pixels is one.
inline constexpr PictureLimits kStrictLimits{0.001, 0.13};
/// For pictures of bodies simulated on another driver: a fall that differs by a pixel is no
/// difference, a missing blade or shadow is one.
inline constexpr PictureLimits kTolerantLimits{0.05, 0.45};

/// Whether the pictures have one size and neither limit is exceeded.
bool withinLimits(const PictureComparison& comparison, const PictureLimits& limits);

/// A picture of the errors: differences from red through orange to yellow over `a` in dark grey,
/// masks striped blue, and a cyan frame around the worst place. Empty if the sizes differ.
/// `comparison` is that of `a` with another picture, with the same options.
Image differencePicture(const Image& a, const PictureComparison& comparison,
                        const ComparisonOptions& options = {});

/// The numerical difference of two pictures, visible or not.
struct ChannelDifference {
    double mean = 0;     ///< mean absolute difference of a channel, alpha too, 0 to 1
    double largest = 0;  ///< largest difference of a channel, 0 to 1
    long pixels = 0;     ///< with a channel that differs by more than 2/255
};
/// Pictures of different sizes have the largest difference, in all pixels of the larger one.
ChannelDifference channelDifference(const Image& a, const Image& b,
                                    const ComparisonOptions& options = {});

}  // namespace kerf::render
