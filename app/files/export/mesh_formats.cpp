#include "app/files/export/mesh_formats.h"

#include "sim/base/text.h"

namespace kerf::app {

std::span<const MeshFormatInfo> meshFormats() {
    static constexpr std::array kFormats{
        MeshFormatInfo{MeshFormat::obj, ".obj", "OBJ"},
        MeshFormatInfo{MeshFormat::ply, ".ply", "PLY"},
        MeshFormatInfo{MeshFormat::stl, ".stl", "STL"},
        MeshFormatInfo{MeshFormat::glb, ".glb", "glTF, binary"},
        MeshFormatInfo{MeshFormat::gltf, ".gltf", "glTF"},
        MeshFormatInfo{MeshFormat::vtp, ".vtp", "VTK"},
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

const MeshFormatInfo& infoOf(MeshFormat format) {
    return *std::ranges::find(meshFormats(), format, &MeshFormatInfo::format);
}

}  // namespace kerf::app
