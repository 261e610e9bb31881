#pragma once

#include <string>
#include <string_view>

namespace kerf::render {

/// Most scans of a JPEG file: each goes over the whole picture, and encoders make some ten.
inline constexpr int kMostScans = 100;

/// Why a JPEG file must not be given to its decoder, in a clause; "" where it may. stb_image 2.27
/// writes past its own Huffman tables where they have more than the 256 codes that there can be,
/// reads tables that were never defined, and decodes scans without end.
std::string faultOfJpeg(std::string_view jpeg);

}  // namespace kerf::render
