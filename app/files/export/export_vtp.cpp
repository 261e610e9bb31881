#include "app/files/export/export_vtp.h"

#include <spdlog/fmt/fmt.h>

#include <bit>

#include "app/files/io/encodings.h"

namespace kerf::app {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie");

template <class T>
constexpr std::string_view kTypeName = "";
template <>
constexpr std::string_view kTypeName<float> = "Float32";
template <>
constexpr std::string_view kTypeName<double> = "Float64";
template <>
constexpr std::string_view kTypeName<std::int32_t> = "Int32";
template <>
constexpr std::string_view kTypeName<std::uint8_t> = "UInt8";

/// An array, with its length in bytes before it.
template <class T>
std::string arrayOf(const std::vector<T>& values, std::string_view name, int components = 1) {
    const auto size = static_cast<std::uint64_t>(values.size() * sizeof(T));
    std::string bytes(reinterpret_cast<const char*>(&size), sizeof size);
    bytes.append(reinterpret_cast<const char*>(values.data()), size);
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}"
        "</DataArray>\n",
        kTypeName<T>, name, components, base64(bytes));
}

template <class Number>
std::string arrayOf(const std::vector<Eigen::Matrix<Number, 3, 1>>& vectors,
                    std::string_view name) {
    std::vector<Number> numbers;
    numbers.reserve(3 * vectors.size());
    for (const auto& vector : vectors) {
        numbers.insert(numbers.end(), vector.begin(), vector.end());
    }
    return arrayOf(numbers, name, 3);
}

template <class T, class ValueOf>
std::string ofFaces(const ExportMesh& mesh, std::string_view name, ValueOf valueOf) {
    std::vector<T> values;
    values.reserve(mesh.faces.size());
    for (const ExportFace& face : mesh.faces) {
        values.push_back(static_cast<T>(valueOf(face)));
    }
    return arrayOf(values, name);
}

std::string cells(const ExportMesh& mesh) {
    std::vector<std::int32_t> corners;
    std::vector<std::int32_t> ends;
    corners.reserve(3 * mesh.faces.size());
    ends.reserve(mesh.faces.size());
    for (const ExportFace& face : mesh.faces) {
        corners.insert(corners.end(), face.corners.begin(), face.corners.end());
        ends.push_back(static_cast<std::int32_t>(corners.size()));
    }
    return arrayOf(corners, "connectivity") + arrayOf(ends, "offsets");
}

std::string cellData(const ExportMesh& mesh) {
    return ofFaces<std::int32_t>(mesh, "piece", [](const ExportFace& f) { return f.piece; }) +
           ofFaces<std::uint8_t>(mesh, "cut", [](const ExportFace& f) { return f.cut ? 1 : 0; }) +
           ofFaces<float>(mesh, "strain", [](const ExportFace& f) { return f.strain; }) +
           ofFaces<double>(mesh, "piece_volume",
                           [&](const ExportFace& f) { return mesh.pieceVolumes[f.piece]; });
}

}  // namespace

std::string encodeVtp(const ExportMesh& mesh) {
    return fmt::format(
        "<?xml version=\"1.0\"?>\n<!-- Kerf, {} -->\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<PolyData>\n"
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n"
        "<PointData Normals=\"Normals\" Vectors=\"velocity\">\n{}{}</PointData>\n"
        "<CellData Scalars=\"piece\">\n{}</CellData>\n"
        "<Points>\n{}</Points>\n<Polys>\n{}</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n",
        mesh.coordinates, mesh.positions.size(), mesh.faces.size(),
        arrayOf(mesh.normals, "Normals"), arrayOf(mesh.velocities, "velocity"), cellData(mesh),
        mesh.farPositions.empty() ? arrayOf(mesh.positions, "Points")
                                  : arrayOf(mesh.farPositions, "Points"),
        cells(mesh));
}

}  // namespace kerf::app
