#pragma once

struct aiScene;

namespace kerf::app {

/// Divides all polygons of more than four corners, in the meshes of a scene, into triangles, and
/// quads with a corner on a side. assimp does it by cutting off ears, and goes wrong where a corner
/// lies on the side of one. Polygons that cross themselves stay as they are, and so do those that
/// name a vertex that is not there. Says of each mesh which kinds of faces it has.
void dividePolygons(const aiScene& scene);

}  // namespace kerf::app
