// Writes what libFuzzer starts from, for each target: DIR/TARGET/corpus with a text a file,
// DIR/TARGET/words.dict with the words; the same for each format of models, with the files of the
// folder MODELS. Prints the names of the targets.
#include <exception>
#include <iostream>

#include "tests/support/fuzz/fuzz_target.h"
#include "tests/support/fuzz/targets.h"
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

/// Those that begin with that byte, where one is given.
void writeSeeds(const FuzzTarget& target, const fs::path& folder,
                std::optional<std::size_t> kind = std::nullopt) {
    fs::create_directories(folder / "corpus");
    int number = 0;
    for (const std::vector<std::string>& texts :
         {target.texts(), target.refused != nullptr ? target.refused() : std::vector<std::string>{},
          foundTexts(target)}) {
        for (const std::string& text : texts) {
            if (!kind || (!text.empty() && text[0] == static_cast<char>(*kind))) {
                writeText(folder / "corpus" / ("sample-" + std::to_string(number++)), text);
            }
        }
    }
    std::string dictionary;
    for (const std::string& word : target.words()) {
        dictionary += word.size() <= kLongestWord ? entryOf(word) : "";
    }
    writeText(folder / "words.dict", dictionary);
}

/// The models in a folder and below, each for the target of all formats and that of its own.
void writeModels(const fs::path& models, const fs::path& folder) {
    int number = 0;
    for (const auto& entry : fs::recursive_directory_iterator(models)) {
        const std::string ending = entry.path().extension();
        const auto kind = std::ranges::find(modelEndings(), ending);
        for (const std::string& target : {std::string("model"), "model" + ending}) {
            if (kind != modelEndings().end()) {
                writeText(
                    folder / target / "corpus" / ("corner-" + std::to_string(number++)),
                    static_cast<char>(kind - modelEndings().begin()) + readBytes(entry.path()));
            }
        }
    }
}

void writeAllSeeds(const fs::path& folder, const fs::path& models) {
    for (const FuzzTarget& target : fuzzTargets()) {
        writeSeeds(target, folder / target.name);
        std::cout << target.name << "\n";
    }
    for (std::size_t kind = 0; kind < modelEndings().size(); ++kind) {
        const std::string name = "model" + std::string(modelEndings()[kind]);
        writeSeeds(*findFuzzTarget("model"), folder / name, kind);
        std::cout << name << "\n";
    }
    writeModels(models, folder);
}

}  // namespace
}  // namespace kerf::test

int main(int count, char** arguments) {
    if (count != 3) {
        std::cerr << "usage: kerf_fuzz_seeds DIR MODELS\n";
        return 2;
    }
    try {
        kerf::test::writeAllSeeds(arguments[1], arguments[2]);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
