#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace kerf::test {

/// What the reader of sessions owes whoever hands it a text: it refuses with an InputError, or what
/// it read can be written and read again as the same session, bit by bit. "" where it kept that,
/// else a sentence about what it broke. Other exceptions pass through.
std::string brokenPromise(const std::string& text);

/// Texts to start from: sessions of every kind, broken ones too.
std::vector<std::string> sessionTexts();
/// What sessions consist of: keys, types, names and limits of the schema, and punctuation.
std::vector<std::string> sessionWords();

/// Changes texts at random, as a fuzzer does; the seed decides everything.
class TextMutator {
  public:
    /// `texts` must not be empty.
    TextMutator(std::vector<std::string> texts, std::uint32_t seed);
    /// One of the texts, changed at some places.
    std::string next();

  private:
    std::size_t below(std::size_t count);
    const std::string& oneOf(const std::vector<std::string>& list);
    void change(std::string& text);
    void changeByte(std::string& text);
    void insertWord(std::string& text);
    void replaceWord(std::string& text);
    void eraseRange(std::string& text);
    void repeatRange(std::string& text);
    void crossOver(std::string& text);

    std::mt19937 random_;
    std::vector<std::string> texts_;
    std::vector<std::string> words_;
};

}  // namespace kerf::test
