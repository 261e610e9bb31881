#include "tests/support/fuzz/fuzz_target.h"

#include <ostream>

#include "tests/paths.h"
#include "tests/support/fuzz/targets.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace fs = std::filesystem;

std::span<const FuzzTarget> fuzzTargets() {
    static constexpr std::array kTargets{
        FuzzTarget{"session", readSessionText, sessionTexts, sessionWords, 100'000, 2'000,
                   refusedSessionTexts},
        FuzzTarget{"study", readStudyText, studyTexts, studyWords, 1'000, 5},
        FuzzTarget{"run", readRunText, runTexts, runWords, 800, 10},
        FuzzTarget{"settings", readSettingsText, settingsTexts, settingsWords, 50'000, 500},
        FuzzTarget{"recent-files", readRecentText, recentTexts, recentWords, 100, 100},
        FuzzTarget{"journal", readJournalText, journalTexts, journalWords, 1'000, 100},
        FuzzTarget{"expectation", readExpectationText, expectationTexts, expectationWords, 400, 5},
        FuzzTarget{"answer", readAnswerBytes, answerTexts, answerWords, 30'000, 100},
        FuzzTarget{"model", readModelBytes, modelTexts, modelWords, 100, 3},
        FuzzTarget{"link", readLinkBytes, linkTexts, linkWords, 30'000, 1'000},
        FuzzTarget{"image", readImageBytes, imageTexts, imageWords, 30'000, 1'000},
    };
    return kTargets;
}

const FuzzTarget* findFuzzTarget(std::string_view name) {
    const auto found = std::ranges::find(fuzzTargets(), name, &FuzzTarget::name);
    return found == fuzzTargets().end() ? nullptr : &*found;
}

std::ostream& operator<<(std::ostream& out, const FuzzTarget& target) {
    return out << target.name;
}

std::vector<std::string> foundTexts(const FuzzTarget& target) {
    std::vector<fs::path> files;
    std::error_code none;
    const fs::path folder = fs::path(KERF_SOURCE_DIR "/tests/fuzz/found") / target.name;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        files.push_back(entry.path());
    }
    std::ranges::sort(files);
    std::vector<std::string> texts(files.size());
    std::ranges::transform(files, texts.begin(), readBytes);
    return texts;
}

}  // namespace kerf::test
