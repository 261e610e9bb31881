#pragma once

#include <string>

namespace kerf {

/// A length [m] in the unit that suits it, with up to three digits: "9.66 m", "12 cm", "3.5 mm".
std::string lengthText(double metres);
/// An area [m^2] likewise: "1.5 m\u00b2", "12 cm\u00b2".
std::string areaText(double squareMetres);
/// A mass [kg] likewise: "900 kg", "12 t", "40 g".
std::string massText(double kilograms);

}  // namespace kerf
