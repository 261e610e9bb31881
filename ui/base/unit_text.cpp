#include "ui/base/unit_text.h"

#include <cctype>
#include <charconv>

namespace kerf::ui {
namespace {

using Word = std::string_view;
constexpr Word kLength = "a length, such as 5 mm";
constexpr Word kStress = "a stress, such as 2 kPa";
constexpr Word kDensity = "a density, such as 3 g/cm3";
constexpr Word kTear = "an energy per area, such as 1 kJ/m2";
constexpr Word kAngle = "an angle, such as 15 deg";

/// factor * 10^exponent of the plain unit of its kind.
struct Unit {
    Word name;
    Word kind;
    int exponent = 0;
    double factor = 1;
};
constexpr std::array kUnits{Unit{"m", kLength},
                            Unit{"in", kLength, 0, 0.0254},
                            Unit{"ft", kLength, 0, 0.3048},
                            Unit{"s", "a time, such as 0.3 s"},
                            Unit{"Pa", kStress},
                            Unit{"N/m2", kStress},
                            Unit{"g/m3", kDensity},
                            Unit{"g/cm3", kDensity, 6},
                            Unit{"m/s", "a speed, such as 5 mm/s"},
                            Unit{"m/s2", "an acceleration, such as 9.81 m/s2"},
                            Unit{"J/m2", kTear},
                            Unit{"N/m", kTear},
                            Unit{"1/s", "a rate, such as 2 1/s"},
                            Unit{"N", "a force, such as 2 N"},
                            Unit{"deg", kAngle},
                            Unit{"\u00b0", kAngle},
                            Unit{"%", "a share, such as 5 %"}};
constexpr std::array<std::pair<Word, int>, 9> kPrefixes{{{"", 0},
                                                         {"k", 3},
                                                         {"M", 6},
                                                         {"G", 9},
                                                         {"c", -2},
                                                         {"m", -3},
                                                         {"u", -6},
                                                         {"\u00b5", -6},
                                                         {"\u03bc", -6}}};

constexpr std::array<std::pair<Word, Word>, 4> kPlain{
    {{" ", ""}, {"^", ""}, {"\u00b2", "2"}, {"\u00b3", "3"}}};

/// "kg / m^3", or with a raised 3, too.
std::optional<Unit> readUnit(Word text) {
    std::string word(text);
    for (const auto& [mark, plain] : kPlain) {
        for (std::size_t at = 0; (at = word.find(mark)) != std::string::npos;) {
            word.replace(at, mark.size(), plain);
        }
    }
    for (const auto& [prefix, power] : kPrefixes) {
        for (const Unit& unit : kUnits) {
            if (word == std::string(prefix).append(unit.name)) {
                return Unit{unit.name, unit.kind, unit.exponent + power, unit.factor};
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::string withRaisedDigits(std::string_view text) {
    std::string raised;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view two = text.substr(i, 2);
        if (two == "^2" || two == "^3") {
            raised += text[++i] == '2' ? "\u00b2" : "\u00b3";
        } else {
            raised += text[i];
        }
    }
    return raised;
}

std::string asLabel(std::string_view name) {
    std::string label(name);
    std::ranges::replace(label, '_', ' ');
    label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
    return label;
}

std::optional<double> readNumber(std::string_view text, std::string_view unit) {
    std::string word(text.substr(std::min(text.find_first_not_of(" +"), text.size())));
    std::ranges::replace(word, ',', '.');
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const Word rest(end, word.data() + word.size());
    if (error != std::errc{} || !std::isfinite(number)) {
        return std::nullopt;
    }
    if (rest.find_first_not_of(' ') == Word::npos) {
        return number;
    }
    const std::optional<Unit> from = readUnit(rest);
    const std::optional<Unit> to = readUnit(unit);
    if (!from || !to || from->kind != to->kind) {
        return std::nullopt;
    }
    const int shift = from->exponent - to->exponent;  // divides where it is negative: exact
    number *= from->factor / to->factor;
    return shift < 0 ? number / std::pow(10, -shift) : number * std::pow(10, shift);
}

std::string whatFits(std::string_view unit) {
    const std::optional<Unit> known = readUnit(unit);
    return "Type " + std::string(known ? known->kind : "a number, such as 2");
}

}  // namespace kerf::ui
