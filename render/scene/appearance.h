#pragma once

#include "render/scene/image.h"
#include "sim/base/math.h"

namespace kerf::render {

/// A material of a model, in the terms of glTF: what a texture and the colours of corners give is
/// multiplied by the base colour.
struct SurfaceMaterial {
    std::string name;
    Eigen::Vector4f baseColor = Eigen::Vector4f::Ones();  ///< linear light, and opacity
    float roughness = 0.6F;                               ///< 0 to 1
    float metallic = 0;                                   ///< 0 to 1
    int image = -1;                                       ///< of the base colour; -1 for none
    bool operator==(const SurfaceMaterial&) const = default;

    template <class Io>
    void archive(Io& io) {
        io(name, baseColor, roughness, metallic, image);
    }
};

/// An image of a model: the bytes of its file, PNG or JPEG, and its pixels.
struct ModelImage {
    std::string name;   ///< of its file, without folders
    std::string bytes;  ///< as they were read
    Image pixels;       ///< empty until they are decoded

    template <class Io>
    void archive(Io& io) {
        io(name, bytes, pixels);
    }
};

/// The model's own looks, besides those of its triangles (SkinAttributes).
struct Appearance {
    std::vector<SurfaceMaterial> materials;
    std::vector<ModelImage> images;
    bool empty() const { return materials.empty() && images.empty(); }

    template <class Io>
    void archive(Io& io) {
        io(materials, images);
    }
};

/// The kinds of images of models, by their first bytes.
enum class ImageKind { png, jpeg };
/// ".png" or ".jpg".
std::string_view endingOf(ImageKind kind);
/// "image/png" or "image/jpeg".
std::string_view mediaTypeOf(ImageKind kind);
/// The kind of a file by its bytes; throws std::runtime_error if it is neither.
ImageKind kindOfImage(std::string_view bytes);

/// Most pixels on a side of a picture of a model, and of all of its pictures together.
inline constexpr int kMaxTextureSide = 16384;
inline constexpr std::size_t kMaxTexturePixels = std::size_t{1} << 28;

/// The size of an image from its header. Throws std::runtime_error with a clause ("it is damaged")
/// for other formats, and for files that are too large, or too short for their size.
PixelRect sizeOfImage(std::string_view bytes);
/// Decodes a picture of sizeOfImage(). Throws as that does.
Image decodeImage(std::string_view bytes);

/// The displayed colour of a material, by which textures are multiplied: black under a texture, as
/// some writers of MTL files leave it, counts as white.
Eigen::Vector4f shownColor(const SurfaceMaterial& material);

/// The size of a JPEG image from its header. Throws std::runtime_error with a clause if that is
/// damaged.
PixelRect sizeOfJpeg(std::string_view bytes);
/// Decodes a JPEG image of sizeOfJpeg(). Throws std::runtime_error with a clause if anything in it
/// is damaged or missing, or if it has too many scans (500), which would take long.
Image decodeJpeg(std::string_view bytes);

}  // namespace kerf::render
