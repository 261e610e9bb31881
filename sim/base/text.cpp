#include "sim/base/text.h"

#include <cstdio>

namespace kerf {

namespace {

struct Unit {
    double size;
    const char* name;
};

/// In the largest unit of which there is at least so much, else in the last.
std::string textIn(std::span<const Unit> units, double value, double least = 0.9995) {
    const auto found = std::ranges::find_if(
        units, [&](const Unit& unit) { return std::fabs(value) >= least * unit.size; });
    const Unit& unit = found == units.end() ? units.back() : *found;
    const double count = value / unit.size;
    char text[48];
    std::snprintf(text, sizeof text, std::fabs(count) < 1000 ? "%.3g %s" : "%.0f %s", count,
                  unit.name);
    return text;
}

}  // namespace

std::string lengthText(double metres) {
    static constexpr std::array kUnits{Unit{1e3, "km"}, Unit{1, "m"}, Unit{1e-2, "cm"},
                                       Unit{1e-3, "mm"}, Unit{1e-6, "\u00b5m"}};
    return textIn(kUnits, metres);
}

std::string millimetreText(double metres) {
    static constexpr std::array kUnits{Unit{1, "m"}, Unit{1e-3, "mm"}};
    return textIn(kUnits, metres);
}

std::string areaText(double squareMetres) {
    static constexpr std::array kUnits{Unit{1e6, "km\u00b2"}, Unit{1, "m\u00b2"},
                                       Unit{1e-4, "cm\u00b2"}, Unit{1e-6, "mm\u00b2"}};
    return textIn(kUnits, squareMetres);
}

std::string volumeText(double cubicMetres) {
    static constexpr std::array kUnits{Unit{1, "m\u00b3"}, Unit{1e-3, "l"}, Unit{1e-6, "ml"}};
    return textIn(kUnits, cubicMetres, 0.1);
}

std::string massText(double kilograms) {
    static constexpr std::array kUnits{Unit{1e9, "million t"}, Unit{1e3, "t"}, Unit{1, "kg"},
                                       Unit{1e-3, "g"}, Unit{1e-6, "mg"}};
    return textIn(kUnits, kilograms);
}

std::string factorText(double factor) {
    char text[32];
    std::snprintf(text, sizeof text, factor < 10 ? "%.2gx" : "%.0fx", factor);
    return text;
}

}  // namespace kerf
