#pragma once

#include "app/files/export/export_mesh.h"

namespace kerf::app {

/// Whether a file is named as an Alembic cache.
bool isCacheFile(const std::filesystem::path& file);

/// Writes a body over time as an Alembic cache (.abc, Ogawa), whose triangles may change from
/// sample to sample: a polygon mesh with velocities, normals, texture coordinates, colours `Cd`,
/// and a face set for each material. Colours are those of displays, as Blender has them. A sample
/// is stored at once, as far as it differs from the one before. The file appears complete or not at
/// all.
class AlembicCache {
  public:
    /// Begins the cache of a body called `name`, whose positions are counted from `origin` [m].
    /// Throws OutputError, like all functions here.
    AlembicCache(const std::filesystem::path& file, const std::string& name, const Vec3& origin);
    ~AlembicCache();

    /// Adds the body at a time [s], later than the one before. All meshes have the same materials.
    /// `moves`: false while time stands; then nothing has a velocity.
    void add(double time, const ExportMesh& mesh, bool moves);
    /// Completes the cache.
    void finish();
    int samples() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kerf::app
