#include "app/files/ply_line_end.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace kerf::app {

namespace {

constexpr std::size_t kMostHeader = 64 << 10;
constexpr std::string_view kLineEnds = "\r\n";

std::string readAtMost(const std::filesystem::path& file, std::size_t most) {
    std::ifstream in(file, std::ios::binary);
    std::string bytes(most, '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(most));
    if (in.bad() || !in.is_open()) {
        throw std::runtime_error("the file can't be read");
    }
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
}

/// Where the line end of a binary header begins whose data begin with a line feed, or npos.
std::size_t unclearEnd(std::string_view header) {
    constexpr std::string_view kLast = "end_header";
    const std::size_t firstLineEnd = header.find_first_of(kLineEnds);
    const auto lineBegin = [&](char end) { return header.find(end + std::string(kLast)); };
    const std::size_t last = std::min(lineBegin('\n'), lineBegin('\r'));
    if (!header.starts_with("ply") || last == std::string_view::npos ||
        header.substr(0, last).find("format binary") == std::string_view::npos) {
        return std::string_view::npos;
    }
    const std::size_t end = last + 1 + kLast.size();
    const std::string_view lineEnd = header.substr(firstLineEnd, 2);
    const std::string_view here = header.substr(end, 2);
    // A carriage return and a line feed end this line, unless carriage returns alone end the
    // others.
    const bool feeds = here == "\n\n" || (here == kLineEnds && lineEnd[0] == '\r');
    return feeds && lineEnd != kLineEnds ? end : std::string_view::npos;
}

}  // namespace

std::optional<std::string> plyWithClearEnd(const std::filesystem::path& file) {
    const std::size_t end = unclearEnd(readAtMost(file, kMostHeader));
    if (end == std::string_view::npos) {
        return std::nullopt;
    }
    std::string bytes = readAtMost(file, std::filesystem::file_size(file));
    return bytes.replace(end, 1, kLineEnds);
}

}  // namespace kerf::app
