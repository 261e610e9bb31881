#pragma once

#include "app/files/jobs/background_job.h"
#include "ui/state/window_state.h"

namespace kerf::app {

/// A driver that gives wrong results.
struct DriverProblem {
    std::string sentence;          ///< the verdict of the examination
    std::filesystem::path report;  ///< the folder with its report; empty for none
};

/// Examines a new driver once: kerf doctor --quick, in a separate process and thread. Its report is
/// kept, so later starts skip it.
class DriverCheck {
  public:
    /// `folder`: for the reports on all drivers; an empty path examines nothing. `driver`: the full
    /// name of this one.
    DriverCheck(const std::filesystem::path& folder, const std::string& driver);

    /// Whether it is running.
    bool looking() const { return looking_ != nullptr; }
    /// The problem found, once; none without problems, or while it is running.
    std::optional<DriverProblem> takeProblem();

  private:
    using Looking = BackgroundJob<std::optional<DriverProblem>>;
    std::unique_ptr<Looking> looking_;
};

/// The choices of questionAbout().
enum DriverChoice { kUseSoftware, kGoOnWithDriver };
/// Asks what to do about such a driver.
ui::Question questionAbout(const DriverProblem& problem);

/// The folder of such reports: $XDG_STATE_HOME/kerf/drivers, by default in ~/.local/state; empty
/// without a home, or if the variable KERF_EXAMINES_DRIVER is "no".
std::filesystem::path defaultDriverReports();

/// Makes contexts of this process use Mesa's software renderer; call it before the first is made.
void useSoftwareRenderer();

}  // namespace kerf::app
