#pragma once

#include <string>

namespace kerf {

/// A length [m] in the unit that suits it, with up to three digits: "9.66 m", "12 cm", "3.5 mm".
std::string lengthText(double metres);
/// An area [m^2] likewise: "1.5 m\u00b2", "12 cm\u00b2".
std::string areaText(double squareMetres);
/// A volume [m^3] likewise, from a tenth of a unit on: "4.19 m\u00b3", "12.3 l", "0.52 ml".
std::string volumeText(double cubicMetres);
/// A mass [kg] likewise: "900 kg", "12 t", "40 g".
std::string massText(double kilograms);
/// A real-time factor, simulated seconds over seconds of the clock, with two digits: "0.037x".
std::string factorText(double factor);

}  // namespace kerf
