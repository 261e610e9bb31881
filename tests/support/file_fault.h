// A call of the system that fails while a file is written.
#pragma once

#include <atomic>

#include "app/files/io/system_file.h"

namespace kerf::test {

/// As long as it lives, the `number`th call (from 1) by which files are written fails with `error`,
/// and where it is `lasting` all after it, too.
class FileFault {
  public:
    FileFault(int number, int error, bool lasting = false) {
        app::setFileFault([this, number, error, lasting] {
            const int now = ++calls_;
            return now == number || (lasting && now > number) ? error : 0;
        });
        number_ = number;
    }
    ~FileFault() { app::setFileFault(nullptr); }
    FileFault(const FileFault&) = delete;
    FileFault& operator=(const FileFault&) = delete;
    /// Whether it came to that call.
    bool struck() const { return calls_ >= number_; }

  private:
    std::atomic<int> calls_ = 0;
    int number_;
};

}  // namespace kerf::test
