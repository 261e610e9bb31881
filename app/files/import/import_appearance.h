#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/files/import/import_protocol.h"

struct aiScene;

namespace kerf::app {

/// The materials of a scene that triangles of `model` name by their numbers in it, and the bytes of
/// their pictures: those in `file` itself, and regular files of limited size in its folder and
/// below. What is missing there is a sentence of the answer. The triangles name them by their
/// numbers in the model then. `file` names the model.
void addAppearance(const aiScene& scene, const std::filesystem::path& file, ImportedModel& model);

/// Numbers the materials that triangles name by their numbers in the file anew, in the order in
/// which these first use them. `add` takes one of the file into the model and returns its number
/// there; -1 for none.
void takeMaterials(ImportedModel& model, const std::function<int(int number)>& add);

/// The roughness for the exponent of a highlight, as Blender converts it.
float roughnessOfHighlight(double exponent);

/// Takes materials and the bytes of their images into a model, each image once.
class ModelImages {
  public:
    /// `file`: that of the model.
    ModelImages(const std::filesystem::path& file, ImportedModel& model);

    /// Adds a material with the image of that name beside the model's file; "" for none. One that
    /// is missing is a remark of the model. Returns the number of the material.
    int add(render::Material material, const std::string& image);
    /// The number of an image that `read` gets; -1, with a remark, where that throws InputError.
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

/// The file beside a model that a name in it means: written with either slash, or with a folder of
/// another machine before it. None where there is none in the model's folder or below.
std::optional<std::filesystem::path> fileBeside(const std::filesystem::path& model,
                                                std::string name);

/// Whether `file` lies in the folder or below, and is regular and not larger than a model may be.
/// `folder` must be canonical.
bool isFileBelow(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace kerf::app
