#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/files/jobs/background_job.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// A driver that gives wrong results.
struct DriverProblem {
    std::string sentence;          ///< what the examination said
    std::filesystem::path report;  ///< the folder with its report; empty where it left none
};

/// Examines the driver once, when Kerf meets it for the first time: kerf doctor --quick, in a
/// process and a thread of its own. Its report stays, so that the next start asks no more.
class DriverCheck {
  public:
    /// `folder`: for the reports on all drivers; an empty path examines nothing. `driver`: all that
    /// this one says of itself.
    DriverCheck(const std::filesystem::path& folder, const std::string& driver);

    /// Whether it is at work.
    bool looking() const { return looking_ != nullptr; }
    /// What it found wrong, once; none where nothing is, or as long as it is at work.
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
/// where there is no home, or where the variable KERF_EXAMINES_DRIVER is "no".
std::filesystem::path defaultDriverReports();

/// Makes contexts of this process use Mesa's renderer on the processor; before the first is made.
void useSoftwareRenderer();

}  // namespace kerf::app
