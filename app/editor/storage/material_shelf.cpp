#include "app/editor/storage/material_shelf.h"

#include "app/files/io/errors.h"

namespace kerf::app {

MaterialShelf::MaterialShelf(std::filesystem::path folder) : folder_(std::move(folder)) {}

std::vector<std::string> MaterialShelf::look() {
    std::vector<std::string> problems;
    try {
        builtin_ = builtinMaterials();
    } catch (const InputError& error) {
        problems.emplace_back(error.what());
    }
    own_ = folder_.empty() ? std::vector<Material>{} : materialsIn(folder_, problems);
    renew();
    return problems;
}

int MaterialShelf::add(const std::filesystem::path& file) {
    Material material = readMaterial(file);
    std::erase_if(opened_, [&](const Material& other) { return other.name == material.name; });
    opened_.push_back(std::move(material));
    renew();
    return static_cast<int>(all_.size()) - 1;
}

const Material* MaterialShelf::find(int number) const {
    return number >= 0 && number < static_cast<int>(all_.size()) ? &all_[number] : nullptr;
}

const Material* MaterialShelf::of(const Params& params, int model) const {
    const auto found = std::ranges::find_if(
        all_, [&](const Material& material) { return isMadeOf(params, material, model); });
    return found == all_.end() ? nullptr : &*found;
}

void MaterialShelf::describe(ui::PanelModel& model) const {
    model.model.materials = rows_;
    for (int m = 0; m < static_cast<int>(model.model.models.size()); ++m) {
        const Material* const found = of(model.parameters.now, m);
        model.model.models[m].material =
            found == nullptr ? -1 : static_cast<int>(found - all_.data());
    }
}

void MaterialShelf::renew() {
    all_ = builtin_;
    all_.insert(all_.end(), own_.begin(), own_.end());
    all_.insert(all_.end(), opened_.begin(), opened_.end());
    rows_.clear();
    rows_.reserve(all_.size());
    for (const Material& material : all_) {
        const bool own = rows_.size() >= builtin_.size();
        rows_.push_back({material.label, describeMaterial(material), own});
    }
}

}  // namespace kerf::app
