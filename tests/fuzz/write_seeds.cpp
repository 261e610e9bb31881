// Writes what libFuzzer starts from: DIR/corpus with a text a file, DIR/session.dict with the
// words.
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/support/session_fuzz.h"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;

void writeFile(const fs::path& file, const std::string& text) {
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    if (!stream.flush()) {
        throw std::runtime_error(file.string() + ": it could not be written.");
    }
}

/// A word as libFuzzer reads it: in quotes, with quotes and backslashes escaped.
std::string entryOf(const std::string& word) {
    std::string entry = "\"";
    for (const char c : word) {
        entry += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    }
    return entry + "\"\n";
}

void writeSeeds(const fs::path& folder) {
    fs::create_directories(folder / "corpus");
    int number = 0;
    for (const std::string& text : sessionTexts()) {
        writeFile(folder / "corpus" / ("sample-" + std::to_string(number++)), text);
    }
    std::string dictionary;
    for (const std::string& word : sessionWords()) {
        dictionary += entryOf(word);
    }
    writeFile(folder / "session.dict", dictionary);
}

}  // namespace
}  // namespace kerf::test

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: kerf_fuzz_seeds DIR\n";
        return 2;
    }
    try {
        kerf::test::writeSeeds(arguments[1]);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
