#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "app/files/export/export.h"
#include "tests/support/shapes.h"

namespace kerf::app {
namespace {

using test::box;

/// Two boxes; one triangle of the second passes for a wall, and an unused vertex lies about.
SurfaceMesh twoPieces() {
    SurfaceMesh mesh = test::meshOf(test::joined(test::boxSoup(), test::boxSoup(), Vec3(3, 0, 0)));
    mesh.addVertex(Vec3(9, 9, 9), Vec3::Zero(), Vec3::Zero());
    return mesh;
}

std::string encode(const SurfaceMesh& mesh, MeshFormat format) {
    return encodeMesh(mesh, findPieces(mesh), format);
}

template <class T>
T valueAt(const std::string& bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

TEST(Export, FormatFollowsTheExtension) {
    EXPECT_EQ(meshFormatOf("a.ply"), MeshFormat::ply);
    EXPECT_EQ(meshFormatOf("b/a.obj"), MeshFormat::obj);
    EXPECT_EQ(meshFormatOf("a.stl"), MeshFormat::stl);
    EXPECT_EQ(meshFormatOf("a.ply.txt"), std::nullopt);
    EXPECT_EQ(meshFormatOf("ply"), std::nullopt);
}

TEST(Export, PlyHoldsSharedVerticesUnitNormalsAndPieces) {
    const std::string bytes = encode(twoPieces(), MeshFormat::ply);
    EXPECT_NE(bytes.find("element vertex 16\n"), std::string::npos);
    EXPECT_NE(bytes.find("element face 24\n"), std::string::npos);
    const std::size_t start = bytes.find("end_header\n") + std::strlen("end_header\n");
    constexpr std::size_t vertexBytes = 24;
    constexpr std::size_t faceBytes = 1 + 12 + 4 + 1;
    ASSERT_EQ(bytes.size(), start + 16 * vertexBytes + 24 * faceBytes);
    for (std::size_t v = 0; v < 16; ++v) {
        Vec3f position;
        Vec3f normal;
        std::memcpy(position.data(), bytes.data() + start + v * vertexBytes, 12);
        std::memcpy(normal.data(), bytes.data() + start + v * vertexBytes + 12, 12);
        EXPECT_NEAR(normal.norm(), 1, 1e-6);
        const Vec3f center = position.x() > 1 ? Vec3f(3, 0, 0) : Vec3f(0, 0, 0);
        EXPECT_GT(normal.dot(position - center), 0) << "vertex " << v;
    }
    std::map<int, int> facesOfPiece;
    for (std::size_t f = 0; f < 24; ++f) {
        const std::size_t face = start + 16 * vertexBytes + f * faceBytes;
        EXPECT_EQ(valueAt<std::uint8_t>(bytes, face), 3);
        EXPECT_LT(valueAt<std::int32_t>(bytes, face + 1), 16);
        ++facesOfPiece[valueAt<std::int32_t>(bytes, face + 13)];
        EXPECT_EQ(valueAt<std::uint8_t>(bytes, face + 17), 0);
    }
    EXPECT_EQ(facesOfPiece, (std::map<int, int>{{0, 12}, {1, 12}}));
}

/// Two triangles back to back, as the walls at the front of a slit lie before it opens.
SurfaceMesh closedSlit() {
    return SurfaceMesh::fromTriangles({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                      {{0, 1, 2}, {0, 2, 1}});
}

TEST(Export, PlyNormalsHaveLengthOneWhereWallsCancelEachOther) {
    const std::string bytes = encode(closedSlit(), MeshFormat::ply);
    const std::size_t start = bytes.find("end_header\n") + std::strlen("end_header\n");
    for (std::size_t v = 0; v < 3; ++v) {
        Vec3f normal;
        std::memcpy(normal.data(), bytes.data() + start + v * 24 + 12, 12);
        EXPECT_NEAR(normal.norm(), 1, 1e-6) << "vertex " << v;
    }
}

TEST(Export, PlyMarksTheFacesOfCuts) {
    SurfaceMesh mesh = box();
    const Triangle corners = mesh.triangle(0);
    SurfaceMesh walled = box();
    walled.removeTriangle(0);
    const int added = walled.addTriangle(corners, SurfaceKind::wall, 0);
    for (int corner = 0; corner < 3; ++corner) {
        walled.setTwin(3 * added + corner, mesh.twin(corner));
        walled.setTwin(mesh.twin(corner), 3 * added + corner);
        walled.setOutgoing(corners[corner], 3 * added + corner);
    }
    const std::string bytes = encode(walled, MeshFormat::ply);
    EXPECT_NE(bytes.find("element face 12\n"), std::string::npos);
    EXPECT_EQ(bytes.back(), 1);
}

TEST(Export, ObjNamesPiecesAndCountsFromOne) {
    std::istringstream text(encode(twoPieces(), MeshFormat::obj));
    std::map<std::string, int> lines;
    std::string objects;
    for (std::string line; std::getline(text, line);) {
        const std::string keyword = line.substr(0, line.find(' '));
        ++lines[keyword];
        if (keyword == "o") objects += line + ";";
        EXPECT_EQ(line.find(" 0//"), std::string::npos);
    }
    EXPECT_EQ(lines["v"], 16);
    EXPECT_EQ(lines["vn"], 16);
    EXPECT_EQ(lines["f"], 24);
    EXPECT_EQ(objects, "o piece_1;o piece_2;");
}

TEST(Export, StlHasOneRecordPerTriangleWithItsPiece) {
    const std::string bytes = encode(twoPieces(), MeshFormat::stl);
    ASSERT_EQ(bytes.size(), 84u + 24 * 50);
    EXPECT_EQ(valueAt<std::uint32_t>(bytes, 80), 24u);
    EXPECT_EQ(valueAt<std::uint16_t>(bytes, 84 + 48), 0);
    EXPECT_EQ(valueAt<std::uint16_t>(bytes, 84 + 23 * 50 + 48), 1);
}

}  // namespace
}  // namespace kerf::app
