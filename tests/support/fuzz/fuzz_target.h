#pragma once

#include <iosfwd>

namespace kerf::test {

/// What came of bytes that a reader was given.
struct FuzzOutcome {
    bool accepted = false;  ///< they were read; otherwise refused
    std::string broken{};   ///< a sentence about a promise that was not kept; "" for none
    bool read = false;      ///< a model file was read, whatever became of it
    bool judged = false;    ///< what was read was compared with what the file says
};

/// A format that Kerf reads, and what its readers owe whoever hands them bytes: they refuse with
/// the exceptions and the kind of sentence that their headers document, or what they read can be
/// written and read again as the same. Other exceptions pass through; time and memory are bounded.
struct FuzzTarget {
    std::string_view name;
    FuzzOutcome (*read)(const std::string& bytes);
    std::vector<std::string> (*texts)();  ///< to start from, at least one
    std::vector<std::string> (*words)();  ///< what texts of the format consist of
    int rounds;                           ///< random texts in the test suite
    int leastAccepted;                    ///< of these, or they say little about what is written
    std::vector<std::string> (*refused)() = nullptr;  ///< further texts, for libFuzzer; or null
};
/// Its name, as tests print it.
std::ostream& operator<<(std::ostream& out, const FuzzTarget& target);

/// All formats. tests/fuzz hands each to libFuzzer, FuzzTargets.* changes their texts at random.
std::span<const FuzzTarget> fuzzTargets();
/// The one of this name; null for none.
const FuzzTarget* findFuzzTarget(std::string_view name);

/// The bytes of tests/fuzz/found/NAME: what has broken a promise once.
std::vector<std::string> foundTexts(const FuzzTarget& target);

}  // namespace kerf::test
