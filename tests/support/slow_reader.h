#pragma once

#include <sys/types.h>

namespace kerf::test {

/// While one lives, models are read by a program that never answers.
class SlowReader {
  public:
    /// Writes the program into `folder`.
    explicit SlowReader(const std::filesystem::path& folder);
    ~SlowReader();
    SlowReader(const SlowReader&) = delete;
    SlowReader& operator=(const SlowReader&) = delete;

    /// The process that was started last; 0 for none yet.
    pid_t process() const;
    /// Waits up to ten seconds for that process to end. False where it goes on.
    bool hasEnded() const;

  private:
    std::filesystem::path pidFile_;
    std::string before_;
};

}  // namespace kerf::test
