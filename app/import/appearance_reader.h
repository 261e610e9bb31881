#pragma once

#include "app/files/import/import_answer.h"
#include "render/scene/appearance.h"
#include "sim/mesh/skin_attributes.h"

struct aiScene;

namespace kerf::app {

/// Adds the materials of a scene that triangles of `model` refer to, and the bytes of their images:
/// those in `file` itself, and regular files of limited size in its folder and below. Missing ones
/// become remarks. The triangles then refer to them by their numbers in the model. `file`: the
/// model's.
void addAppearance(const aiScene& scene, const std::filesystem::path& file, ImportedModel& model);

/// Renumbers the materials that triangles name by their numbers in the file, in order of first use.
/// `add` adds one of the file to the model and returns its number there; -1 for none.
void takeMaterials(ImportedModel& model, const std::function<int(int number)>& add);

/// The roughness for the exponent of a highlight, as Blender converts it.
float roughnessOfHighlight(double exponent);

/// Takes materials and the bytes of their images into a model, each image once.
class ModelImages {
  public:
    /// `file`: that of the model.
    ModelImages(const std::filesystem::path& file, ImportedModel& model);

    /// Adds a material with the image of that name beside the model's file; "" for none. A missing
    /// one becomes a remark. Returns the number of the material.
    int add(render::SurfaceMaterial material, const std::string& image);
    /// The number of an image from `read`; -1, with a remark, if that throws InputError.
    int numberOf(const std::string& name, const std::function<render::ModelImage()>& read);

    /// The image of that name beside the model's file. Throws InputError where it is missing.
    render::ModelImage read(const std::string& name, const std::string& material) const;

  private:
    int take(render::ModelImage image);

    const std::filesystem::path& file_;
    ImportedModel& model_;
    std::map<std::string, int> images_;
    std::uint64_t bytes_ = 0;
};

/// The file beside a model for a name in it: with either slash, or with a folder of another
/// machine. None if there is none in the model's folder or below.
std::optional<std::filesystem::path> fileBeside(const std::filesystem::path& model,
                                                std::string name);

/// Whether `file` is in the folder or below, regular and within the size limit of models. `folder`
/// must be canonical.
bool isFileBelow(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace kerf::app
