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
    /// Whether all written data reached the system; true if closed already.
    bool close();

  private:
    int number_;
};

/// Opens unusable files as 0, 1 and 2 if a program starts without them: otherwise the next opened
/// file would get one, and with it standard output or error.
void holdStandardStreams();

/// A pipe to a child. Both ends are closed on exec, unless duplicated.
struct Pipe {
    /// Throws OutputError if there are too many open files.
    static std::array<int, 2> open();
    explicit Pipe(std::array<int, 2> ends = open()) : read(ends[0]), write(ends[1]) {}
    Descriptor read;
    Descriptor write;
};

}  // namespace kerf::app
