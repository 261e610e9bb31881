#pragma once

#include "app/files/import/model_source.h"

namespace kerf::app {

/// The models of a scene in one mesh, in order, with all their looks. None may be missing.
ModelMesh joinedModels(std::vector<ModelMesh> models);

/// Gives the triangles of a model without a material one of this display colour. `name` is that of
/// the material.
void paint(ModelMesh& model, const std::string& name, const Vec3& color);

}  // namespace kerf::app
