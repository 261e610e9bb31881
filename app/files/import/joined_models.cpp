#include "app/files/import/joined_models.h"

#include "render/scene/body_look.h"

namespace kerf::app {

namespace {

SurfaceMesh joinedMeshes(const std::vector<ModelMesh>& models) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    for (const ModelMesh& model : models) {
        const int first = static_cast<int>(positions.size());
        for (int t = 0; t < model.mesh.triangleSlots(); ++t) {
            const Triangle& corners = model.mesh.triangle(t);
            triangles.push_back({corners[0] + first, corners[1] + first, corners[2] + first});
        }
        std::ranges::copy(model.mesh.restPositions(), std::back_inserter(positions));
    }
    return SurfaceMesh::fromTriangles(positions, triangles);
}

/// Makes the lists that some of the models have.
SkinAttributes roomFor(const std::vector<ModelMesh>& models) {
    SkinAttributes skin;
    std::size_t triangles = 0;
    for (const ModelMesh& model : models) {
        const SkinAttributes& own = model.looks.skin;
        const std::size_t one = 1;
        skin.uvs.resize(std::max(skin.uvs.size(), std::min(one, own.uvs.size())));
        skin.colors.resize(std::max(skin.colors.size(), std::min(one, own.colors.size())));
        skin.materials.resize(std::max(skin.materials.size(), std::min(one, own.materials.size())));
        triangles += model.mesh.triangleSlots();
    }
    resizeAttributes(skin, triangles);
    return skin;
}

SkinAttributes joinedSkins(const std::vector<ModelMesh>& models) {
    SkinAttributes skin = roomFor(models);
    int first = 0;
    int firstMaterial = 0;
    for (const ModelMesh& model : models) {
        for (int t = 0; t < model.mesh.triangleSlots(); ++t) {
            TriangleAttributes attributes = attributesOf(model.looks.skin, t);
            attributes.material += attributes.material >= 0 ? firstMaterial : 0;
            setAttributes(skin, first + t, attributes);
        }
        first += model.mesh.triangleSlots();
        const auto& appearance = model.looks.appearance;
        firstMaterial += appearance ? static_cast<int>(appearance->materials.size()) : 0;
    }
    return skin;
}

std::shared_ptr<const render::Appearance> joinedAppearances(const std::vector<ModelMesh>& models) {
    render::Appearance all;
    for (const ModelMesh& model : models) {
        if (const auto& own = model.looks.appearance) {
            const int firstImage = static_cast<int>(all.images.size());
            for (render::SurfaceMaterial material : own->materials) {
                material.image += material.image >= 0 ? firstImage : 0;
                all.materials.push_back(std::move(material));
            }
            std::ranges::copy(own->images, std::back_inserter(all.images));
        }
    }
    return all.empty() ? nullptr : std::make_shared<const render::Appearance>(std::move(all));
}

std::vector<PlacedModel> joinedPlaces(const std::vector<ModelMesh>& models) {
    std::vector<PlacedModel> placed;
    int first = 0;
    for (const ModelMesh& model : models) {
        for (const PlacedModel& one : model.placed) {
            placed.push_back({one.placement, one.firstVertex + first});
        }
        first += model.mesh.vertexCount();
    }
    return placed;
}

/// What can be wrong with models that can be cut concerns triangles alone.
repair::Faults joinedFaults(const std::vector<ModelMesh>& models) {
    repair::Faults faults;
    int first = 0;
    for (const ModelMesh& model : models) {
        for (std::size_t k = 0; k < faults.places.size(); ++k) {
            for (const int t : model.faults.places[k].triangles) {
                faults.places[k].triangles.push_back(first + t);
            }
        }
        first += model.mesh.triangleSlots();
    }
    return faults;
}

}  // namespace

ModelMesh joinedModels(std::vector<ModelMesh> models) {
    if (models.size() == 1) {
        return std::move(models.front());
    }
    ModelMesh all(joinedMeshes(models), {joinedSkins(models), joinedAppearances(models)});
    for (ModelMesh& model : models) {
        std::ranges::move(model.remarks, std::back_inserter(all.remarks));
    }
    all.placed = joinedPlaces(models);
    all.origin = models.front().origin;
    all.faults = joinedFaults(models);
    return all;
}

void paint(ModelMesh& model, const std::string& name, const Vec3& color) {
    auto appearance = std::make_shared<render::Appearance>();
    if (model.looks.appearance) {
        *appearance = *model.looks.appearance;
    }
    SkinAttributes& skin = model.looks.skin;
    skin.materials.resize(model.mesh.triangleSlots(), -1);
    const int own = static_cast<int>(appearance->materials.size());
    std::ranges::replace(skin.materials, -1, own);
    render::SurfaceMaterial material;
    material.name = name;
    material.baseColor.head<3>() = render::toLinear(color);
    appearance->materials.push_back(std::move(material));
    model.looks.appearance = std::move(appearance);
}

}  // namespace kerf::app
