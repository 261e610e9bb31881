#include "app/import/appearance_reader.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

/// Materials that assimp makes up where a file names none.
bool isMadeUpName(std::string_view name) {
    static constexpr std::array<std::string_view, 3> kNames{"", "DefaultMaterial", "%%%DEFAULT"};
    return std::ranges::find(kNames, name) != kNames.end();
}

Eigen::Vector4f colorOf(const aiMaterial& material) {
    aiColor4D color(1, 1, 1, 1);
    float opacity = 1;
    if (material.Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS) {
        material.Get(AI_MATKEY_COLOR_DIFFUSE, color);
        material.Get(AI_MATKEY_OPACITY, opacity);
        color.a = opacity;
    }
    const Eigen::Vector4f out(color.r, color.g, color.b, color.a);
    return out.allFinite() ? out : Eigen::Vector4f(Eigen::Vector4f::Ones());
}

float roughnessOf(const aiMaterial& material) {
    float roughness = render::SurfaceMaterial{}.roughness;
    float shininess = 0;
    if (material.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness) != aiReturn_SUCCESS &&
        material.Get(AI_MATKEY_SHININESS, shininess) == aiReturn_SUCCESS && shininess > 0) {
        roughness = roughnessOfHighlight(shininess);
    }
    return std::isfinite(roughness) ? std::clamp(roughness, 0.0F, 1.0F) : 1;
}

float metallicOf(const aiMaterial& material) {
    float metallic = 0;
    material.Get(AI_MATKEY_METALLIC_FACTOR, metallic);
    return std::isfinite(metallic) ? std::clamp(metallic, 0.0F, 1.0F) : 0;
}

/// The name by which a material asks for its picture; empty for none.
std::string imageNameOf(const aiMaterial& material) {
    aiString name;
    if (material.GetTexture(aiTextureType_BASE_COLOR, 0, &name) != aiReturn_SUCCESS) {
        material.GetTexture(aiTextureType_DIFFUSE, 0, &name);
    }
    return name.C_Str();
}

/// Takes over the materials of one scene, each once.
class AppearanceReader {
  public:
    AppearanceReader(const aiScene& scene, const fs::path& file, ImportedModel& model)
        : scene_(scene), model_(model), images_(file, model) {}

    /// Returns its number among those of the model; -1 where a file named none.
    int add(unsigned index) {
        if (index >= scene_.mNumMaterials) {
            return -1;
        }
        const aiMaterial& from = *scene_.mMaterials[index];
        render::SurfaceMaterial material;
        material.name = from.GetName().C_Str();
        material.baseColor = colorOf(from);
        material.roughness = roughnessOf(from);
        material.metallic = metallicOf(from);
        const std::string image = imageNameOf(from);
        if (isMadeUpName(material.name) && image.empty()) {
            return -1;
        }
        if (!image.empty()) {
            material.image =
                images_.numberOf(image, [&] { return readImage(image, material.name); });
        }
        model_.appearance.materials.push_back(std::move(material));
        return static_cast<int>(model_.appearance.materials.size()) - 1;
    }

  private:
    render::ModelImage readImage(const std::string& name, const std::string& material) const {
        if (const aiTexture* within = scene_.GetEmbeddedTexture(name.c_str())) {
            return embedded(*within, material);
        }
        return images_.read(name, material);
    }

    static render::ModelImage embedded(const aiTexture& texture, const std::string& material) {
        if (texture.mHeight != 0) {
            throw InputError("The image within the file of the material \"" + material +
                             "\" was left out: it is neither PNG nor JPEG.");
        }
        const std::string name = fs::path(texture.mFilename.C_Str()).filename().string();
        return {name.empty() ? material : name,
                std::string(reinterpret_cast<const char*>(texture.pcData), texture.mWidth),
                {}};
    }

    const aiScene& scene_;
    ImportedModel& model_;
    ModelImages images_;
};

}  // namespace

float roughnessOfHighlight(double exponent) {
    return static_cast<float>(1 - std::sqrt(std::clamp(exponent, 0.0, 900.0)) / 30);
}

bool isFileBelow(const fs::path& folder, const fs::path& file) {
    std::error_code error;
    return leadsInside(folder, file) && fs::is_regular_file(file, error) &&
           fs::file_size(file, error) <= kMaxModelBytes && !error;
}

ModelImages::ModelImages(const fs::path& file, ImportedModel& model) : file_(file), model_(model) {}

int ModelImages::add(render::SurfaceMaterial material, const std::string& image) {
    if (!image.empty()) {
        material.image = numberOf(image, [&] { return read(image, material.name); });
    }
    model_.appearance.materials.push_back(std::move(material));
    return static_cast<int>(model_.appearance.materials.size()) - 1;
}

int ModelImages::numberOf(const std::string& name,
                          const std::function<render::ModelImage()>& read) {
    const auto [place, isNew] = images_.try_emplace(name, -1);
    if (isNew) {
        try {
            place->second = take(read());
        } catch (const InputError& error) {
            model_.remarks.emplace_back(error.what());
        }
    }
    return place->second;
}

render::ModelImage ModelImages::read(const std::string& name, const std::string& material) const {
    const std::optional<fs::path> file = fileBeside(file_, name);
    if (!file) {
        throw InputError("The image \"" + name + "\" of the material \"" + material +
                         "\" was left out: there is no such file in the model's folder or "
                         "below; put it there and open the model again.");
    }
    return {file->filename().string(), readInputFile(*file, kMaxImportImages), {}};
}

int ModelImages::take(render::ModelImage image) {
    bytes_ += image.bytes.size();
    if (bytes_ > kMaxImportImages) {
        throw InputError("The image \"" + image.name +
                         "\" was left out: the images of a model may have 500 MB together.");
    }
    model_.appearance.images.push_back(std::move(image));
    return static_cast<int>(model_.appearance.images.size()) - 1;
}

std::optional<fs::path> fileBeside(const fs::path& model, std::string name) {
    const fs::path folder = fs::canonical(model).parent_path();
    std::ranges::replace(name, '\\', '/');
    for (const fs::path& way : {fs::path(name), fs::path(name).filename()}) {
        if (way.is_relative() && isFileBelow(folder, folder / way)) {
            return folder / way;
        }
    }
    return std::nullopt;
}

void takeMaterials(ImportedModel& model, const std::function<int(int)>& add) {
    std::map<int, int> numbers;
    for (int& material : model.soup.skin.materials) {
        if (material >= 0) {
            const auto [place, isNew] = numbers.try_emplace(material, -1);
            if (isNew) {
                place->second = add(material);
            }
            material = place->second;
        }
    }
    if (model.appearance.materials.empty()) {
        model.soup.skin.materials.clear();
    }
}

void addAppearance(const aiScene& scene, const fs::path& file, ImportedModel& model) {
    AppearanceReader reader(scene, file, model);
    takeMaterials(model, [&](int number) { return reader.add(static_cast<unsigned>(number)); });
}

}  // namespace kerf::app
