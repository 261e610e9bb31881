#pragma once

#include "app/session/material.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The materials to choose from: built-in ones, those of the user's folder, and those of opened
/// files.
class MaterialShelf {
  public:
    /// Reads the user's own from `folder`; an empty path has none.
    explicit MaterialShelf(std::filesystem::path folder);

    const std::filesystem::path& folder() const { return folder_; }
    /// Reads them again. Returns sentences about files that can't be read.
    std::vector<std::string> look();
    /// Adds the material of a file, replacing its previous one. Returns its number. Throws
    /// InputError.
    int add(const std::filesystem::path& file);
    /// By number; null for none.
    const Material* find(int number) const;
    /// What a model is made of by its parameters; null for none of these.
    const Material* of(const Params& params, int model = 0) const;
    /// Sets the list that panels show, and which of it each model is made of.
    void describe(ui::PanelModel& model) const;

  private:
    void renew();

    std::filesystem::path folder_;
    std::vector<Material> builtin_;
    std::vector<Material> own_;     ///< of the folder
    std::vector<Material> opened_;  ///< of other files
    std::vector<Material> all_;
    std::vector<ui::MaterialRow> rows_;  ///< of `all_`
};

}  // namespace kerf::app
