#pragma once

#include <ctime>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/files/io/descriptor.h"
#include "app/journal/journal_text.h"
#include "render/scene/image.h"

namespace kerf::app {

/// The journals that are kept at most, and for how long.
inline constexpr std::size_t kMostLeftJournals = 20;
inline constexpr int kDaysOfJournals = 30;

/// A journal that a window left behind: it ended without being closed. It is ours alone as long as
/// this lives.
class LeftJournal {
  public:
    /// Takes the lock of a journal. False then for isOurs() where a window has it, or it is gone.
    explicit LeftJournal(std::filesystem::path file);

    bool isOurs() const { return ours_; }
    const std::filesystem::path& file() const { return file_; }
    /// Takes it away with its picture.
    void remove();

  private:
    std::filesystem::path file_;
    Descriptor descriptor_;
    bool ours_;
};

/// Work that can be gone on from.
struct LeftWork {
    std::shared_ptr<LeftJournal> journal;
    KeptWork kept;
    std::time_t when = 0;                          ///< it was done last
    std::shared_ptr<const render::Image> picture;  ///< null for none
};

/// Looks through a folder for what windows left behind, the last first. Takes away what nobody
/// needs: journals without unsaved work, and those beyond the number and the age that are kept.
std::vector<LeftWork> lookForLeftWork(const std::filesystem::path& folder);

/// $XDG_STATE_HOME/kerf/journal, by default below ~/.local/state; empty without a home.
std::filesystem::path defaultJournalFolder();

}  // namespace kerf::app
