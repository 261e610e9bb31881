#include "app/files/descriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "app/files/file_io.h"

namespace kerf::app {

bool Descriptor::close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0;
}

std::array<int, 2> Pipe::open() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw OutputError(std::string("There is no pipe to another process (") +
                          std::strerror(errno) + ").");
    }
    return ends;
}

}  // namespace kerf::app
