#pragma once

#include "app/files/import/model_units.h"
#include "render/scene/appearance.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// Largest model file that is read [bytes].
inline constexpr std::uintmax_t kMaxModelBytes = 1'000'000'000;
/// Most vertices and triangles that a model file may hold.
inline constexpr std::uint64_t kMaxImportVertices = 60'000'000;
inline constexpr std::uint64_t kMaxImportTriangles = 20'000'000;
/// Least and largest extent of a model, in the unit of its numbers.
inline constexpr double kMinImportExtent = 1e-6;
inline constexpr double kMaxImportExtent = 1e10;

/// Most bytes of the images of a model together.
inline constexpr std::uint64_t kMaxImportImages = 500'000'000;
/// Most bytes of the description of materials and images in an answer.
inline constexpr std::uint64_t kMaxImportLooks = 16'000'000;

/// A model as read from its file.
struct ImportedModel {
    TriangleSoup soup;
    FileFacts facts{};                   ///< objects by their numbers in the soup
    render::Appearance appearance{};     ///< pictures are not decoded
    std::vector<std::string> remarks{};  ///< sentences about what was skipped
};

/// Head of the answer of a reader process, which is an ImportHeader in the machine's own byte
/// order. Where `failed` is 1, `messageLength` bytes follow that say why. Else there follow
/// `vertices` positions of three doubles, `triangles` of three 32-bit indices, then for each
/// triangle six floats where `textured` is 1, twelve where `colored` is 1, and a 32-bit index each
/// where `materials` and `objects` are 1, then `messageLength` bytes of JSON (materials, images,
/// names of objects, units, remarks), and the bytes of the images one after the other.
struct ImportHeader {
    char magic[8];
    std::uint64_t failed;
    std::uint64_t vertices;
    std::uint64_t triangles;
    std::uint64_t messageLength;
    std::uint64_t textured;
    std::uint64_t colored;
    std::uint64_t materials;
    std::uint64_t objects;
};
static_assert(sizeof(ImportHeader) == 72);

/// Where an answer tells its counts [bytes].
inline constexpr std::size_t kImportHeadBytes = sizeof(ImportHeader);
/// The number of triangles by the beginning of an answer, which is not trusted; 0 for none.
std::uint64_t trianglesByHead(std::string_view head);

/// Most bytes that an answer within the limits can have.
inline constexpr std::uint64_t kMaxImportAnswer = sizeof(ImportHeader) + kMaxImportVertices * 24 +
                                                  kMaxImportTriangles * (12 + 24 + 48 + 4 + 4) +
                                                  kMaxImportLooks + kMaxImportImages;

/// Encodes an answer of the reader process: the model, or why there is none.
std::string encodeImport(const ImportedModel& model);
std::string encodeImportFailure(std::string_view message);

/// Decodes an answer and trusts nothing in it: lengths, counts and indices are checked; texture
/// coordinates and colours that are not finite become 0. Throws InputError with what is wrong,
/// without the file's name.
ImportedModel decodeImport(std::string_view answer);

/// Throws InputError if a coordinate is not finite or the extent is out of bounds.
void checkImportedPositions(const TriangleSoup& soup);

}  // namespace kerf::app
