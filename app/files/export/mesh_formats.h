#pragma once

namespace kerf::app {

/// Formats of mesh files.
enum class MeshFormat { ply, obj, stl, glb, gltf, vtp };

struct MeshFormatInfo {
    MeshFormat format = MeshFormat::obj;
    std::string_view extension;  ///< ".obj"
    std::string_view name;       ///< as people call it
};
/// All formats, in the order of the dialog.
std::span<const MeshFormatInfo> meshFormats();
/// The format of a file's extension; none for any other extension.
std::optional<MeshFormat> meshFormatOf(const std::filesystem::path& file);
/// The row of a format.
const MeshFormatInfo& infoOf(MeshFormat format);

/// The coordinates of a written mesh.
enum class Coordinates {
    model,  ///< those of the model's own file: its unit, axes and place
    scene,  ///< metres of the scene, +y up
};
/// In the order of the enumerators.
inline constexpr std::string_view kCoordinatesNames[] = {"model", "scene"};

}  // namespace kerf::app
