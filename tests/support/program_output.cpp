#include "tests/support/program_output.h"

#include <cstdio>

namespace kerf::test {

std::string outputOf(const std::string& command) {
    std::string text;
    FILE* pipe = ::popen(command.c_str(), "r");
    std::array<char, 256> chunk{};
    while (pipe != nullptr && std::fgets(chunk.data(), chunk.size(), pipe) != nullptr) {
        text += chunk.data();
    }
    return pipe == nullptr || ::pclose(pipe) != 0 ? text + "failed\n" : text;
}

}  // namespace kerf::test
