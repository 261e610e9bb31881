#pragma once

#include <array>

namespace kerf::app {

/// A file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    /// Its number; -1 once closed.
    int get() const { return number_; }
    /// Whether all that was written reached the system; true for one that is closed already.
    bool close();

  private:
    int number_;
};

/// Gives the numbers 0, 1 and 2 to files that can't be used where a program starts without them:
/// else the next file that it opens would get one, and with it what is meant for people.
void holdStandardStreams();

/// A pipe to a child. Neither end outlives an exec, unless it is copied.
struct Pipe {
    /// Throws OutputError where there are too many open files.
    static std::array<int, 2> open();
    explicit Pipe(std::array<int, 2> ends = open()) : read(ends[0]), write(ends[1]) {}
    Descriptor read;
    Descriptor write;
};

}  // namespace kerf::app
