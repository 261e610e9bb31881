#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/panel_model.h"

namespace kerf::app {

/// A sentence in the view that fades by itself; errors stay longer. All that was shown stays in the
/// log.
class EditorToast {
  public:
    /// Shows a sentence instead of the one before, and notes it in the log.
    void show(std::string text, bool isError);
    /// The same with a button for what can be done about it.
    void offer(std::string text, ui::HintChoice choice);
    /// Whether such a button is there.
    bool offers() const { return visible() && choice_.has_value(); }
    /// Lets time go by.
    void elapse(double elapsedSeconds);
    bool visible() const { return remaining_ > 0; }
    /// Time for which the sentence stays as it is [s]; 0 while it fades.
    double steadySeconds() const;
    /// Sets the model's toast and its log.
    void describe(ui::PanelModel& model) const;

  private:
    std::string text_;
    std::vector<ui::LogLine> log_;
    bool isError_ = false;
    std::optional<ui::HintChoice> choice_;
    double remaining_ = 0;
};

}  // namespace kerf::app
