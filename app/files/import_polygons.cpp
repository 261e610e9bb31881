#include "app/files/import_polygons.h"

#include <assimp/scene.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "sim/mesh/triangle.h"
#include "sim/repair/polygon_triangles.h"

namespace kerf::app {

namespace {

bool isPolygon(const aiFace& face) {
    return face.mNumIndices > 3;
}

bool isInRange(const aiMesh& mesh, const aiFace& face) {
    return std::ranges::all_of(std::span(face.mIndices, face.mNumIndices),
                               [&](unsigned v) { return v < mesh.mNumVertices; });
}

std::vector<Vec3> cornersOf(const aiMesh& mesh, const aiFace& face) {
    std::vector<Vec3> corners;
    for (const unsigned v : std::span(face.mIndices, face.mNumIndices)) {
        const aiVector3D& p = mesh.mVertices[v];
        corners.emplace_back(p.x, p.y, p.z);
    }
    return corners;
}

/// Whether a corner lies in line with its neighbours.
bool hasStraightCorner(const std::vector<Vec3>& corners) {
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (areaNormal({corners[i], corners[(i + 1) % count], corners[(i + 2) % count]})
                .isZero(0)) {
            return true;
        }
    }
    return false;
}

/// None where assimp is to divide the face, or to refuse it. Quads it divides right, but for those
/// that are triangles with a corner on a side.
std::vector<Triangle> trianglesOf(const aiMesh& mesh, const aiFace& face) {
    if (!isPolygon(face) || !isInRange(mesh, face)) {
        return {};
    }
    const std::vector<Vec3> corners = cornersOf(mesh, face);
    const bool plainQuad = corners.size() == 4 && !hasStraightCorner(corners);
    return plainQuad ? std::vector<Triangle>{} : repair::triangulatePolygon(corners);
}

void append(const aiFace& face, const std::vector<Triangle>& triangles,
            std::vector<aiFace>& faces) {
    for (const Triangle& t : triangles) {
        aiFace& part = faces.emplace_back();
        part.mNumIndices = 3;
        part.mIndices = new unsigned[3];  // The face deletes it.
        std::ranges::transform(t, part.mIndices, [&](int corner) { return face.mIndices[corner]; });
    }
}

void divideFacesOf(aiMesh& mesh) {
    std::vector<aiFace> divided;
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
        const std::vector<Triangle> triangles = trianglesOf(mesh, face);
        if (triangles.empty()) {
            divided.push_back(face);
        } else {
            append(face, triangles, divided);
        }
    }
    auto* now = new aiFace[divided.size()];  // The mesh deletes it.
    std::ranges::copy(divided, now);
    delete[] std::exchange(mesh.mFaces, now);
    mesh.mNumFaces = static_cast<unsigned>(divided.size());
}

/// As they are once polygons are divided.
unsigned typesOf(std::span<const aiFace> faces) {
    unsigned types = 0;
    for (const aiFace& face : faces) {
        types |= face.mNumIndices == 1   ? aiPrimitiveType_POINT
                 : face.mNumIndices == 2 ? aiPrimitiveType_LINE
                 : face.mNumIndices == 3 ? aiPrimitiveType_TRIANGLE
                                         : aiPrimitiveType_POLYGON;
    }
    return types;
}

}  // namespace

void dividePolygons(const aiScene& scene) {
    for (aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
        const std::span faces(mesh->mFaces, mesh->mNumFaces);
        if (std::ranges::any_of(faces, isPolygon)) {
            divideFacesOf(*mesh);
        }
        mesh->mPrimitiveTypes = typesOf({mesh->mFaces, mesh->mNumFaces});
    }
}

}  // namespace kerf::app
