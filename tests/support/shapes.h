#pragma once

#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf::test {

// Closed, outward-oriented test shapes around the origin, lengths in metres. Each comes as a
// TriangleSoup and as a SurfaceMesh.

/// An icosahedron, each triangle split in four `subdivisions` times: 20 * 4^s triangles.
TriangleSoup icosphereSoup(int subdivisions, double radius = 0.5);
/// A cube with n x n quads a face, pushed out to the sphere: 12 * n^2 triangles.
TriangleSoup cubeSphereSoup(int n, double radius = 0.5);
/// A ring in the x-z plane: 2 * around * across triangles, genus 1.
TriangleSoup torusSoup(int around = 32, int across = 16, double radius = 0.35, double tube = 0.15);
/// A bent, tapered tube with closed ends, like a banana: bends in the x-y plane, about 1 m long.
TriangleSoup bentTubeSoup(int along = 24, int around = 12);
/// A sphere with edges of `coarse` at x = -radius and an eighth of that at x = radius, growing
/// evenly (by equal factors) between.
TriangleSoup gradedSphereSoup(double coarse = 0.16, double radius = 0.5);
/// A ring in the x-z plane with edges of `coarse` at its end in -x and an eighth at that in +x.
TriangleSoup gradedTorusSoup(double coarse = 0.16, double radius = 0.35, double tube = 0.15);
/// An axis-parallel box with n x n quads a face: 12 * n^2 triangles.
TriangleSoup boxSoup(const Vec3& size = Vec3::Ones(), int n = 1);

/// The soup's mesh; it must be closed, manifold and oriented.
SurfaceMesh meshOf(const TriangleSoup& soup);

SurfaceMesh icosphere(int subdivisions, double radius = 0.5);
SurfaceMesh cubeSphere(int n, double radius = 0.5);
SurfaceMesh torus(int around = 32, int across = 16, double radius = 0.35, double tube = 0.15);
SurfaceMesh bentTube(int along = 24, int around = 12);
SurfaceMesh gradedSphere(double coarse = 0.16);
SurfaceMesh gradedTorus(double coarse = 0.16);
SurfaceMesh box(const Vec3& size = Vec3::Ones(), int n = 1);
/// The mesh elsewhere, at rest too.
SurfaceMesh movedBy(SurfaceMesh mesh, const Vec3& way);
/// The mean of its vertices.
Vec3 middleOf(const SurfaceMesh& mesh);
/// Of its living vertices [m/s].
double topSpeed(const SurfaceMesh& mesh);

/// A builtin model as its file has it, read without assimp and without a child process: "sphere20",
/// "sphere80", "sphere768", "banana" or "octopus".
TriangleSoup builtinSoup(const std::string& name);
SurfaceMesh builtin(const std::string& name);

/// The soup as the text of an OBJ file, six decimals a coordinate.
std::string objText(const TriangleSoup& soup);

/// Both soups in one, `second` moved by `offset`.
TriangleSoup joined(const TriangleSoup& first, const TriangleSoup& second, const Vec3& offset);
/// The soup with each triangle facing the other way.
TriangleSoup turned(TriangleSoup soup);
/// `outer` with a cavity in it, which has the shape of `inner` moved by `offset`.
SurfaceMesh hollow(const TriangleSoup& outer, const TriangleSoup& inner, const Vec3& offset);

}  // namespace kerf::test
