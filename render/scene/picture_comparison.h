#pragma once

#include <cstddef>
#include <vector>

#include "render/scene/image.h"

namespace kerf::render {

/// The error of a pixel from which on a person who flips between two pictures notices it.
inline constexpr float kVisibleError = 0.1F;
/// The side of a place: an error over so many pixels in a square is seen as one [pixels].
inline constexpr int kPlaceSide = 12;

/// What to leave out when two pictures are compared.
struct ComparisonOptions {
    std::vector<PixelRect> masks;  ///< what lies in them changes no figure; they may overlap
};

/// How two pictures differ for people. Errors are those of `flipErrors`, from 0 to 1.
struct PictureComparison {
    bool sameSize = false;
    bool identical = false;  ///< the same bytes outside the masks
    /// By pixel, 0 in masks; empty where the sizes differ.
    std::vector<float> errors;
    long pixelsCompared = 0;   ///< those outside the masks
    long pixelsDiffering = 0;  ///< with an error above kVisibleError
    double mean = 0;           ///< of the errors of the pixels compared
    double worst = 0;          ///< largest mean error of a square of kPlaceSide pixels
    PixelRect worstPlace;      ///< that square; empty where nothing differs

    /// pixelsDiffering as a share of those compared.
    double shareDiffering() const;
};

/// Compares two pictures as people see them. Where a pixel is not opaque, the pictures are seen
/// over black and over white, and the larger error counts. Pictures of different sizes differ in
/// all pixels of the larger one, with mean and worst 1.
PictureComparison comparePictures(const Image& a, const Image& b,
                                  const ComparisonOptions& options = {});

/// How far two pictures may be apart and still count as equal.
struct PictureLimits {
    double pixels = 0;  ///< of PictureComparison::shareDiffering
    double worst = 0;   ///< of PictureComparison::worst
};

/// For pictures of one driver, or of the same bodies drawn by another: noise of one grey level is
/// no difference, a piece that moved by two pixels is one.
inline constexpr PictureLimits kStrictLimits{0.001, 0.13};
/// For pictures of bodies that another driver simulated too: where they fell otherwise by a pixel
/// is no difference, a blade or a shadow that is gone is one.
inline constexpr PictureLimits kTolerantLimits{0.05, 0.45};

/// Whether the pictures have one size and neither limit is exceeded.
bool withinLimits(const PictureComparison& comparison, const PictureLimits& limits);

/// A picture of the errors: what differs glows from red through orange to yellow over `a` in dark
/// grey, masks are striped blue, and a cyan frame surrounds the worst place. Empty where the
/// sizes differ. `comparison` is that of `a` with another picture, with the same options.
Image differencePicture(const Image& a, const PictureComparison& comparison,
                        const ComparisonOptions& options = {});

/// How far two pictures are apart as numbers, whether it is seen or not.
struct ChannelDifference {
    double mean = 0;     ///< mean absolute difference of a channel, alpha too, 0 to 1
    double largest = 0;  ///< largest difference of a channel, 0 to 1
    long pixels = 0;     ///< with a channel that differs by more than 2/255
};
/// Pictures of different sizes are as far apart as can be, in all pixels of the larger one.
ChannelDifference channelDifference(const Image& a, const Image& b,
                                    const ComparisonOptions& options = {});

}  // namespace kerf::render
