// Writes what libFuzzer starts from, for each target: DIR/TARGET/corpus with a text a file,
// DIR/TARGET/words.dict with the words. Prints the names of the targets.
#include <exception>
#include <filesystem>
#include <iostream>

#include "tests/support/fuzz/fuzz_target.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestWord = 64;  // libFuzzer's own limit

std::string hexOf(unsigned char c) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    return {'\\', 'x', kDigits[c >> 4], kDigits[c & 15]};
}

/// A word as libFuzzer reads it: in quotes, with all but plain letters as numbers.
std::string entryOf(const std::string& word) {
    std::string entry = "\"";
    for (const char c : word) {
        const bool plain = c > ' ' && c <= '~' && c != '"' && c != '\\';
        entry += plain ? std::string(1, c) : hexOf(static_cast<unsigned char>(c));
    }
    return entry + "\"\n";
}

void writeSeeds(const FuzzTarget& target, const fs::path& folder) {
    fs::create_directories(folder / "corpus");
    int number = 0;
    for (const std::vector<std::string>& texts :
         {target.texts(), target.refused != nullptr ? target.refused() : std::vector<std::string>{},
          foundTexts(target)}) {
        for (const std::string& text : texts) {
            writeText(folder / "corpus" / ("sample-" + std::to_string(number++)), text);
        }
    }
    std::string dictionary;
    for (const std::string& word : target.words()) {
        dictionary += word.size() <= kLongestWord ? entryOf(word) : "";
    }
    writeText(folder / "words.dict", dictionary);
}

}  // namespace
}  // namespace kerf::test

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: kerf_fuzz_seeds DIR\n";
        return 2;
    }
    try {
        for (const auto& target : kerf::test::fuzzTargets()) {
            kerf::test::writeSeeds(target, std::filesystem::path(arguments[1]) / target.name);
            std::cout << target.name << "\n";
        }
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
