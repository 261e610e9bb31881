#pragma once

namespace kerf {

/// A number with its noun: "1 piece", "3 pieces".
template <class Number>
std::string counted(Number count, std::string_view one, std::string_view many) {
    return std::to_string(count).append(" ").append(count == 1 ? one : many);
}

/// All words, or the words that `wordOf` gives for the items, in one text with `separator` between.
template <class Items, class WordOf = std::identity>
std::string joined(const Items& items, std::string_view separator, WordOf wordOf = {}) {
    std::string text;
    for (const auto& item : items) {
        text.append(text.empty() ? "" : separator).append(std::invoke(wordOf, item));
    }
    return text;
}

/// Words as a sentence lists them: "a", "a and b", "a, b and c".
template <class Words>
std::string enumerated(const Words& words) {
    std::string text;
    std::size_t left = std::size(words);
    for (const auto& word : words) {
        text.append(text.empty() ? "" : left == 1 ? " and " : ", ").append(word);
        --left;
    }
    return text;
}

/// The text with '?' for each control character, since file names may hold anything that breaks a
/// line or controls the terminal.
inline std::string printable(std::string text) {
    for (char& c : text) {
        c = static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
    return text;
}

/// At most the first `size` bytes of a text, cut between two characters of UTF-8.
inline std::string beginningOf(const std::string& text, std::size_t size) {
    if (text.size() <= size) {
        return text;
    }
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xc0) == 0x80) --size;
    return text.substr(0, size);
}

/// At most the last `size` bytes of a text, cut between two characters of UTF-8.
inline std::string endOf(const std::string& text, std::size_t size) {
    std::size_t from = text.size() - std::min(size, text.size());
    while (from < text.size() && (static_cast<unsigned char>(text[from]) & 0xc0) == 0x80) ++from;
    return text.substr(from);
}

/// The text of a file for a quotation: printable, and shortened if it is long.
inline std::string shortened(const std::string& text) {
    constexpr std::size_t kMost = 60;
    return printable(beginningOf(text, kMost)) + (text.size() > kMost ? "..." : "");
}

/// ASCII letters in lower case.
inline std::string lowerCase(std::string text) {
    for (char& c : text) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return text;
}

/// A length [m] in the unit that suits it, with up to three digits: "9.66 m", "12 cm", "3.5 mm".
std::string lengthText(double metres);
/// A length that is set, in millimetres below a metre: "5 mm", "120 mm".
std::string millimetreText(double metres);
/// An area [m^2] likewise: "1.5 m\u00b2", "12 cm\u00b2".
std::string areaText(double squareMetres);
/// A volume [m^3] likewise, from a tenth of a unit on: "4.19 m\u00b3", "12.3 l", "0.52 ml".
std::string volumeText(double cubicMetres);
/// A mass [kg] likewise: "900 kg", "12 t", "40 g".
std::string massText(double kilograms);
/// A real-time factor, simulated seconds over seconds of the clock, with two digits: "0.037x".
std::string factorText(double factor);

}  // namespace kerf
