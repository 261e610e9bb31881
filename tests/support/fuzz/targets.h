// The functions of the formats in fuzzTargets(), which says what each is for.
#pragma once

#include "tests/support/fuzz/fuzz_target.h"

namespace kerf::test {

/// A session file.
FuzzOutcome readSessionText(const std::string& text);
std::vector<std::string> sessionTexts();
std::vector<std::string> refusedSessionTexts();
std::vector<std::string> sessionWords();

/// The file of a study, beside two sessions.
FuzzOutcome readStudyText(const std::string& text);
std::vector<std::string> studyTexts();
std::vector<std::string> studyWords();

/// The folder of a run of a study, packed: run.json, summary.json, metrics.csv.
FuzzOutcome readRunText(const std::string& text);
std::vector<std::string> runTexts();
std::vector<std::string> runWords();

/// The settings of the editor.
FuzzOutcome readSettingsText(const std::string& text);
std::vector<std::string> settingsTexts();
std::vector<std::string> settingsWords();

/// The editor's list of recent files.
FuzzOutcome readRecentText(const std::string& text);
std::vector<std::string> recentTexts();
std::vector<std::string> recentWords();

/// A journal.
FuzzOutcome readJournalText(const std::string& text);
std::vector<std::string> journalTexts();
std::vector<std::string> journalWords();

/// A folder of expectations, packed: expected.json, course.csv, pieces.csv, hashes.csv.
FuzzOutcome readExpectationText(const std::string& text);
std::vector<std::string> expectationTexts();
std::vector<std::string> expectationWords();

/// The answer of the process that reads models.
FuzzOutcome readAnswerBytes(const std::string& bytes);
std::vector<std::string> answerTexts();
std::vector<std::string> answerWords();

/// A model file behind a byte that chooses its extension. The suite reads it as Kerf does, through
/// a process of its own; libFuzzer sees only what happens in this one.
/// What a file says of its faces (countOf) must arrive, or a remark say that it did not.
FuzzOutcome readModelBytes(const std::string& bytes);
std::vector<std::string> modelTexts();
std::vector<std::string> modelWords();
/// Extensions such as ".obj"; that byte is a number of this list.
std::span<const std::string_view> modelEndings();
/// From here on readModelBytes() reads models in this process.
void readModelsInThisProcess();

/// What a client of the link sends, as it is and with the right checksums.
FuzzOutcome readLinkBytes(const std::string& bytes);
std::vector<std::string> linkTexts();
std::vector<std::string> linkWords();

/// A picture, PNG or JPEG.
FuzzOutcome readImageBytes(const std::string& bytes);
std::vector<std::string> imageTexts();
std::vector<std::string> imageWords();

}  // namespace kerf::test
