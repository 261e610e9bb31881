#pragma once

#include <string>

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// What thicken() did.
struct Thickening {
    int sheets = 0;        ///< that became bodies
    double thickness = 0;  ///< of these [m]
    /// Why nothing was changed, and what to do: a clause. Empty where all went well.
    std::string problem = {};
};

/// Makes a body of each sheet of a welded soup, a part with a border: half of the thickness [m] to
/// each side, closed by strips along its borders. Flat faces and what is folded along a line get
/// that thickness exactly; at corners sharper than 60 degrees it is less. Both sides keep their
/// attributes, and a strip has those of the triangle beside it. Closed parts stay. Refused is what
/// branches, has one side alone, or would pass through itself or through another part that does not
/// nearly touch it. A thickness of 0 is a fiftieth of the diagonal, or less where that is refused.
Thickening thicken(TriangleSoup& soup, double thickness);

/// Whether the borders of a welded soup are long for what they enclose, as those of a cloth are and
/// those of holes in a body are not. A hemisphere counts as a sheet.
bool isSheet(const TriangleSoup& soup);

}  // namespace kerf::repair
