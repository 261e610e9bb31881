#include "app/import/vtk_mesh.h"

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

CellShape shapeOf(double type) {
    using enum CellShape;
    static const std::map<CellShape, std::set<double>> types{
        {leftOut, {0, 1, 2, 3, 4, 21, 35, 68, 75}},
        {strip, {6}},
        {polygon, {7}},
        {pixel, {8}},
        {voxel, {11}},
        {triangle, {5, 22, 34, 69, 76}},
        {quad, {9, 23, 28, 30, 70, 77}},
        {tetrahedron, {10, 24, 71, 78}},
        {hexahedron, {12, 25, 29, 33, 72, 79}},
        {wedge, {13, 26, 31, 32, 73, 80}},
        {pyramid, {14, 27, 37, 74, 81}}};
    const auto found =
        std::ranges::find_if(types, [&](const auto& row) { return row.second.contains(type); });
    if (found == types.end()) {
        throw InputError("it has cells of VTK's type " + formatNumber(type) +
                         ", which are not read; export its surface (in ParaView: Extract Surface)");
    }
    return found->first;
}

}  // namespace

void requireVtkSurface(const std::string& kind) {
    std::string plain = lowerCase(kind);
    std::erase(plain, '_');
    if (plain != "polydata" && plain != "unstructuredgrid") {
        throw InputError("it is a data set of the kind \"" + printable(kind.substr(0, 40)) +
                         "\", not of surfaces; export these (in ParaView: Extract Surface)");
    }
}

bool isVtkColor(std::string_view name, double components, bool ofBytes) {
    const std::string small = lowerCase(std::string(name));
    const bool named = small.find("rgb") != std::string::npos ||
                       small.find("color") != std::string::npos ||
                       small.find("colour") != std::string::npos;
    return (components == 3 || components == 4) && (named || ofBytes);
}

void VtkMesh::addPoints(const std::vector<double>& coordinates) {
    first_ = faces_.positions.size();
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
        faces_.positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    }
}

void VtkMesh::addCells(const VtkCells& cells, const std::vector<double>& pieces) {
    const std::size_t count = cells.ends.size();
    if (cells.types.size() != count) {
        throw InputError("it has " + counted(count, "cell", "cells") + " and " +
                         std::to_string(cells.types.size()) + " types of cells");
    }
    double begin = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double end = cells.ends[i];
        if (!(end >= begin && end <= static_cast<double>(cells.corners.size()))) {
            throw InputError("the corners of cell " + std::to_string(i) + " end at " +
                             formatNumber(end) + ", and there are " +
                             std::to_string(cells.corners.size()));
        }
        std::vector<double> corners(cells.corners.begin() + std::ptrdiff_t(begin),
                                    cells.corners.begin() + std::ptrdiff_t(end));
        for (double& corner : corners) {
            corner += corner < 0 ? 0 : static_cast<double>(first_);
        }
        if (pieces.size() == count) {
            faces_.enterObject("piece_" + formatNumber(pieces[i] + 1));
        }
        cells_.add(shapeOf(cells.types[i]), corners);
        begin = end;
    }
}

void VtkMesh::addColors(std::size_t components, double most, const std::vector<double>& numbers) {
    if (faces_.vertexColors.size() > first_) {
        return;  // Another array has them.
    }
    faces_.vertexColors.resize(first_, kNoColor);
    for (std::size_t i = 0; i + components <= numbers.size(); i += components) {
        Eigen::Vector4d color = Eigen::Vector4d::Ones();
        for (std::size_t k = 0; k < components; ++k) {
            color[static_cast<Eigen::Index>(k)] = numbers[i + k] / most;
        }
        faces_.vertexColors.push_back(color.cast<float>());
    }
}

ImportedModel VtkMesh::takeModel() {
    ImportedModel model;
    cells_.finish(model.remarks);
    makeLinear(faces_.vertexColors);
    takeFaces(faces_, model);
    return model;
}

}  // namespace kerf::app
