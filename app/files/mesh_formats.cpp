#include "app/files/mesh_formats.h"

#include <array>

#include "sim/base/text.h"

namespace kerf::app {

std::span<const MeshFormatInfo> meshFormats() {
    static constexpr std::array kFormats{
        MeshFormatInfo{MeshFormat::obj, ".obj", "OBJ"},
        MeshFormatInfo{MeshFormat::ply, ".ply", "PLY"},
        MeshFormatInfo{MeshFormat::stl, ".stl", "STL"},
        MeshFormatInfo{MeshFormat::glb, ".glb", "glTF, binary"},
        MeshFormatInfo{MeshFormat::gltf, ".gltf", "glTF"},
    };
    return kFormats;
}

std::optional<MeshFormat> meshFormatOf(const std::filesystem::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    for (const MeshFormatInfo& info : meshFormats()) {
        if (info.extension == extension) {
            return info.format;
        }
    }
    return std::nullopt;
}

}  // namespace kerf::app
