#pragma once

#include <string>
#include <vector>

#include "ui/panel_model.h"

namespace kerf::app {

/// A sentence in the view that fades by itself; errors stay longer. All that was shown stays in the
/// log.
class EditorToast {
  public:
    /// Takes the place of what is shown.
    void show(std::string text, bool isError);
    void elapse(double elapsedSeconds);
    bool visible() const { return remaining_ > 0; }
    /// How long it stays as it is [s]; 0 while it fades.
    double steadySeconds() const;
    /// Sets text, kind and opacity of the model's toast, and its log.
    void describe(ui::PanelModel& model) const;

  private:
    std::string text_;
    std::vector<ui::LogLine> log_;
    bool isError_ = false;
    double remaining_ = 0;
};

}  // namespace kerf::app
