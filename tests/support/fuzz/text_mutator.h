#pragma once

#include <random>

namespace kerf::test {

/// The words and numbers in texts, each once.
std::vector<std::string> wordsOf(const std::vector<std::string>& texts);
/// The same in quotes, as values and as keys of JSON, with its punctuation and odd numbers.
std::vector<std::string> jsonWordsOf(const std::vector<std::string>& texts);

/// Changes texts at random, as a fuzzer does; the seed decides everything.
class TextMutator {
  public:
    /// Neither `texts` nor `words`, what they consist of, may be empty.
    TextMutator(std::vector<std::string> texts, std::vector<std::string> words, std::uint32_t seed);
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
