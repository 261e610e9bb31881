#include "app/files/off_faces.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace kerf::app {

namespace {

/// The next line with more than space and a comment in it, or nothing at the end.
bool nextLine(std::ifstream& in, std::istringstream& words) {
    for (std::string line; std::getline(in, line);) {
        line.resize(std::min(line.find('#'), line.size()));
        if (line.find_first_not_of(" \t\r") != std::string::npos) {
            words = std::istringstream(line);
            return true;
        }
    }
    return false;
}

struct OffCounts {
    long long vertices = 0;
    long long faces = 0;
};

/// From the first line, or the one behind a line that names the format alone.
OffCounts countsOf(std::ifstream& in) {
    OffCounts counts;
    std::istringstream words;
    if (!nextLine(in, words)) {
        return counts;
    }
    if (std::string name; words.str().find("OFF") != std::string::npos) {
        words >> name;
    }
    if (!(words >> counts.vertices >> counts.faces) && nextLine(in, words)) {
        words >> counts.vertices >> counts.faces;
    }
    return counts;
}

}  // namespace

std::optional<std::string> offWithoutComments(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (std::find(std::istreambuf_iterator<char>(in), {}, '#') ==
        std::istreambuf_iterator<char>()) {
        return std::nullopt;
    }
    in.clear();
    in.seekg(0);
    std::string text;
    for (std::istringstream words; nextLine(in, words);) {
        text += words.str() + "\n";
    }
    return text;
}

int mostCornersOfOff(const std::filesystem::path& file) {
    std::ifstream in(file);
    const OffCounts counts = countsOf(in);
    std::istringstream words;
    for (long long v = 0; v < counts.vertices; ++v) {
        if (!nextLine(in, words)) {
            return 0;
        }
    }
    int most = 0;
    for (long long face = 0; face < counts.faces && nextLine(in, words); ++face) {
        int corners = 0;
        words >> corners;
        most = std::max(most, corners);
    }
    return most;
}

}  // namespace kerf::app
