#include "app/files/descriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "app/files/file_io.h"

namespace kerf::app {

void Descriptor::close() {
    if (number_ >= 0) {
        ::close(number_);
        number_ = -1;
    }
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
