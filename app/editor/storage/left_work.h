#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/files/jobs/background_job.h"
#include "app/journal/journal_folder.h"
#include "app/scene/document/document_loading.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The work of windows that ended without being closed: searched once on a separate thread, and
/// offered one after the other.
class LeftWorkOffers {
  public:
    bool comingBack = false;  ///< recovered work is still being played, see Editor::State

    /// Begins to search `folder`; an empty path has nothing.
    explicit LeftWorkOffers(const std::filesystem::path& folder);

    /// Searches again, for newer work.
    void lookAgain();
    /// Whether the thread is still searching.
    bool looking() const { return looking_ != nullptr; }
    /// Takes what the thread has found, once done; call it once a frame.
    void collect();
    /// The next work to offer, each once; the newest first.
    std::optional<LeftWork> next();
    /// Postpones the others to the next start.
    void putOff() { works_.clear(); }

  private:
    using Looking = BackgroundJob<std::vector<LeftWork>>;

    std::filesystem::path folder_;
    std::unique_ptr<Looking> looking_;
    std::deque<LeftWork> works_;
};

/// The choices of questionAbout().
enum LeftWorkChoice { kGoOn, kDiscard, kNotNow };
/// Asks what to do with such work.
ui::Question questionAbout(const LeftWork& work);
/// The order to recover it. A failure says where it is kept.
OpeningOrder orderOf(const LeftWork& work);

}  // namespace kerf::app
