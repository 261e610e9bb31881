#include "sim/base/quantity_text.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <span>

namespace kerf {
namespace {

struct Unit {
    double size;
    const char* name;
};

/// In the largest unit of which there is at least one, else in the last.
std::string textIn(std::span<const Unit> units, double value) {
    const double size = std::fabs(value);
    const Unit* unit = &units.back();
    for (const Unit& candidate : units) {
        if (size >= 0.9995 * candidate.size) {
            unit = &candidate;
            break;
        }
    }
    const double count = value / unit->size;
    char text[48];
    std::snprintf(text, sizeof text, std::fabs(count) < 1000 ? "%.3g %s" : "%.0f %s", count,
                  unit->name);
    return text;
}

}  // namespace

std::string lengthText(double metres) {
    static constexpr std::array kUnits{Unit{1e3, "km"}, Unit{1, "m"}, Unit{1e-2, "cm"},
                                       Unit{1e-3, "mm"}, Unit{1e-6, "\u00b5m"}};
    return textIn(kUnits, metres);
}

std::string areaText(double squareMetres) {
    static constexpr std::array kUnits{Unit{1e6, "km\u00b2"}, Unit{1, "m\u00b2"},
                                       Unit{1e-4, "cm\u00b2"}, Unit{1e-6, "mm\u00b2"}};
    return textIn(kUnits, squareMetres);
}

std::string massText(double kilograms) {
    static constexpr std::array kUnits{Unit{1e9, "million t"}, Unit{1e3, "t"}, Unit{1, "kg"},
                                       Unit{1e-3, "g"}, Unit{1e-6, "mg"}};
    return textIn(kUnits, kilograms);
}

}  // namespace kerf
