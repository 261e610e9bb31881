#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// The result of thicken().
struct Thickening {
    int sheets = 0;        ///< that became bodies
    double thickness = 0;  ///< of these [m]
    /// Why nothing was changed, and what to do: a clause. Empty on success.
    std::string problem = {};
};

/// Makes a body of each sheet of a welded soup, a part with a border: half of the thickness [m] to
/// each side, closed by strips along its borders. Flat faces and folds along a line get that
/// thickness exactly; at corners sharper than 60 degrees it is less. Both sides keep their
/// attributes, and a strip has those of the triangle beside it. Closed parts stay. Refuses sheets
/// that branch, are one-sided, or would intersect themselves or another part that does not nearly
/// touch them. A thickness of 0 is a fiftieth of the diagonal, or less if that is refused.
Thickening thicken(TriangleSoup& soup, double thickness);

/// Whether the borders of a welded soup are long for the enclosed area, like those of a cloth and
/// unlike those of holes in a body. A hemisphere counts as a sheet.
bool isSheet(const TriangleSoup& soup);

}  // namespace kerf::app
