#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/session/material.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The materials that a person can choose: those that come with Kerf, those of the person's folder,
/// and those of files that were opened.
class MaterialShelf {
  public:
    /// Looks into `folder` for the person's own; an empty path has none.
    explicit MaterialShelf(std::filesystem::path folder);

    const std::filesystem::path& folder() const { return folder_; }
    /// Looks again. Returns sentences about files that can't be read.
    std::vector<std::string> look();
    /// Puts the material of a file onto the shelf, in place of the one that it had there. Returns
    /// its number. Throws InputError.
    int add(const std::filesystem::path& file);
    /// By number; null where there is none of it.
    const Material* find(int number) const;
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
