#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// Most vertices and triangles that a model file may hold.
inline constexpr std::uint64_t kMaxImportVertices = 60'000'000;
inline constexpr std::uint64_t kMaxImportTriangles = 20'000'000;
/// A model's longest side [m] must lie between these.
inline constexpr double kMinImportExtent = 1e-6;
inline constexpr double kMaxImportExtent = 1e6;

/// Head of the answer of a reader process, which is an ImportHeader in the machine's own byte
/// order, then either `vertices` positions of three doubles, `triangles` of three 32-bit indices
/// and, where `textured` is 1, six floats for each triangle, or, where `failed` is 1,
/// `messageLength` bytes that say why.
struct ImportHeader {
    char magic[8];
    std::uint64_t failed;
    std::uint64_t vertices;
    std::uint64_t triangles;
    std::uint64_t messageLength;
    std::uint64_t textured;
};
static_assert(sizeof(ImportHeader) == 48);

/// Most bytes that an answer within the limits can have.
inline constexpr std::uint64_t kMaxImportAnswer =
    sizeof(ImportHeader) + kMaxImportVertices * 24 + kMaxImportTriangles * (12 + 24);

/// Answers of the reader process: the triangles, or why there are none.
std::string encodeImport(const TriangleSoup& soup);
std::string encodeImportFailure(std::string_view message);

/// Decodes an answer and trusts nothing in it: lengths, counts and indices are checked; texture
/// coordinates that are no finite numbers become 0. Throws
/// InputError with what is wrong, without the file's name.
TriangleSoup decodeImport(std::string_view answer);

/// Throws InputError where a coordinate is not finite or the extent is out of bounds.
void checkImportedPositions(const TriangleSoup& soup);

}  // namespace kerf::app
