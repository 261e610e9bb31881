#include "app/files/import_polygons.h"

#include <assimp/scene.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "sim/repair/polygon_triangles.h"

namespace kerf::app {

namespace {

constexpr unsigned kMostOfOthers = 4;  // assimp divides quads right

bool isPolygon(const aiFace& face) {
    return face.mNumIndices > kMostOfOthers;
}

bool isInRange(const aiMesh& mesh, const aiFace& face) {
    return std::ranges::all_of(std::span(face.mIndices, face.mNumIndices),
                               [&](unsigned v) { return v < mesh.mNumVertices; });
}

/// None where assimp is to divide the face, or to refuse it.
std::vector<Triangle> trianglesOf(const aiMesh& mesh, const aiFace& face) {
    if (!isPolygon(face) || !isInRange(mesh, face)) {
        return {};
    }
    std::vector<Vec3> corners;
    for (const unsigned v : std::span(face.mIndices, face.mNumIndices)) {
        const aiVector3D& p = mesh.mVertices[v];
        corners.emplace_back(p.x, p.y, p.z);
    }
    return repair::triangulatePolygon(corners);
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

void dividePolygons(aiMesh& mesh) {
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

/// The reader of OBJ files names no lines and points among its polygons.
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
            dividePolygons(*mesh);
        }
        mesh->mPrimitiveTypes = typesOf({mesh->mFaces, mesh->mNumFaces});
    }
}

}  // namespace kerf::app
