#include "tests/support/fuzz/text_mutator.h"

#include <cctype>

namespace kerf::test {

namespace {

bool isPartOfWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-';
}

}  // namespace

std::vector<std::string> wordsOf(const std::vector<std::string>& texts) {
    std::set<std::string> words;
    for (const std::string& text : texts) {
        for (auto first = text.begin(); first != text.end();) {
            first = std::find_if(first, text.end(), isPartOfWord);
            const auto last = std::find_if_not(first, text.end(), isPartOfWord);
            words.emplace(first, last);
            first = last;
        }
    }
    words.erase("");
    return {words.begin(), words.end()};
}

std::vector<std::string> jsonWordsOf(const std::vector<std::string>& texts) {
    std::vector<std::string> words{
        "{",    "}",         "[",     "]",       ",",     ":",          "\"",
        "null", "true",      "false", "-0.0",    "1e308", "5e-324",     "-1",
        "2.5",  "[0, 1, 2]", "{},",   "\\u0000", "../",   "4294967296", "9223372036854775808"};
    for (const std::string& word : wordsOf(texts)) {
        words.push_back("\"" + word + "\"");
        words.push_back("\"" + word + "\": ");
    }
    return words;
}

TextMutator::TextMutator(std::vector<std::string> texts, std::vector<std::string> words,
                         std::uint32_t seed)
    : random_(seed), texts_(std::move(texts)), words_(std::move(words)) {}

std::string TextMutator::next() {
    std::string text = oneOf(texts_);
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
        change(text);
    }
    return text;
}

/// Not std::uniform_int_distribution, which differs between libraries.
std::size_t TextMutator::below(std::size_t count) {
    return random_() % count;
}

const std::string& TextMutator::oneOf(const std::vector<std::string>& list) {
    return list[below(list.size())];
}

void TextMutator::change(std::string& text) {
    constexpr std::array kChanges{&TextMutator::changeByte,  &TextMutator::insertWord,
                                  &TextMutator::replaceWord, &TextMutator::eraseRange,
                                  &TextMutator::repeatRange, &TextMutator::crossOver};
    (this->*kChanges[below(kChanges.size())])(text);
}

void TextMutator::changeByte(std::string& text) {
    if (!text.empty()) {
        text[below(text.size())] = static_cast<char>(below(256));
    }
}

void TextMutator::insertWord(std::string& text) {
    text.insert(below(text.size() + 1), oneOf(words_));
}

/// A number, or the letters of a key or a name.
void TextMutator::replaceWord(std::string& text) {
    const std::size_t place = below(text.size() + 1);
    const auto first = std::find_if(text.begin() + place, text.end(), isPartOfWord);
    const auto last = std::find_if_not(first, text.end(), isPartOfWord);
    std::string word = oneOf(words_);
    std::erase(word, '"');
    text.replace(first, last, word);
}

void TextMutator::eraseRange(std::string& text) {
    const std::size_t place = below(text.size() + 1);
    text.erase(place, below(30));
}

void TextMutator::repeatRange(std::string& text) {
    const std::size_t place = below(text.size() + 1);
    text.insert(below(text.size() + 1), text.substr(place, below(60)));
}

/// Goes on as another text does.
void TextMutator::crossOver(std::string& text) {
    const std::string& other = oneOf(texts_);
    text.resize(below(text.size() + 1));
    text += other.substr(below(other.size() + 1));
}

}  // namespace kerf::test
