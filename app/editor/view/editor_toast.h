#pragma once

#include "app/files/jobs/saving_queue.h"
#include "app/scene/timeline/event_log.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// A message in the view that fades; errors stay longer. All messages stay in the log. The message
/// about a screenshot may offer it as a picture of the session.
class EditorToast {
  public:
    /// Shows a message instead of the previous one, and logs it.
    void show(std::string text, bool isError);
    /// Shows a message with a possible action.
    void offer(std::string text, ui::HintChoice choice);
    /// Shows the end of a save, which may be that of offerOnceSaved().
    void show(const SavingQueue::Outcome& outcome);
    /// Offers the screenshot taken at `place`, once the save of that number has ended.
    void offerOnceSaved(const LogPosition& place, int saving) { offer_ = {place, saving}; }
    void withdrawOffer() { offer_.reset(); }
    /// Takes the place of the screenshot offered in the view; none if none is.
    std::optional<LogPosition> takeOffer();
    /// Advances time.
    void elapse(double elapsedSeconds);
    bool visible() const { return remaining_ > 0; }
    /// Time until the message fades [s]; 0 while it fades.
    double steadySeconds() const;
    /// Sets the model's toast and its log.
    void describe(ui::PanelModel& model) const;

  private:
    std::string text_;
    std::vector<ui::LogLine> log_;
    bool isError_ = false;
    std::optional<ui::HintChoice> choice_;  ///< possible action
    double remaining_ = 0;
    struct Offer {
        LogPosition place;
        int saving = 0;  ///< its number
    };
    std::optional<Offer> offer_;
};

}  // namespace kerf::app
