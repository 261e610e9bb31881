#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/files/jobs/saving_queue.h"
#include "app/scene/timeline/session_journal.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// A sentence in the view that fades by itself; errors stay longer. All that was shown stays in the
/// log. The sentence about a screenshot may offer it as a picture of the session.
class EditorToast {
  public:
    /// Shows a sentence instead of the one before, and notes it in the log.
    void show(std::string text, bool isError);
    /// Shows a sentence with something that can be done about it.
    void offer(std::string text, ui::HintChoice choice);
    /// Shows the end of a saving, which may be that of offerOnceSaved().
    void show(const SavingQueue::Outcome& outcome);
    /// Offers the screenshot taken at `place`, once the saving of that number has ended.
    void offerOnceSaved(const JournalPlace& place, int saving) { offer_ = {place, saving}; }
    void withdrawOffer() { offer_.reset(); }
    /// The place of the screenshot that is offered in the view, and no more from now on; none where
    /// none is.
    std::optional<JournalPlace> takeOffer();
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
    std::optional<ui::HintChoice> choice_;  ///< what can be done about it
    double remaining_ = 0;
    struct Offer {
        JournalPlace place;
        int saving = 0;  ///< its number
    };
    std::optional<Offer> offer_;
};

}  // namespace kerf::app
