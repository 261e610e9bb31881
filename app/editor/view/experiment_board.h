#pragma once

#include <map>
#include <string>

#include "ui/state/panel_model.h"

namespace kerf::app {

class EditorScene;

/// The paper's experiments with its figures and our measurements: of the open run, or of the last
/// one in this window.
class ExperimentBoard {
  public:
    /// Takes the figures of the scene, if it is one of the experiments.
    void note(const EditorScene& scene);
    /// Sets the cards, and the paper's figures for the open experiment; `scene` may be null.
    void describe(const EditorScene* scene, ui::PanelModel& model) const;

  private:
    struct Run {
        ui::RunFigures figures;
        int triangles = 0;
    };
    std::map<std::string, Run, std::less<>> runs_;  ///< by the experiment's name
};

}  // namespace kerf::app
