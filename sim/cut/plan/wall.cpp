#include "sim/cut/plan/wall.h"

#include "sim/cut/plan/chords.h"
#include "sim/cut/plan/ears.h"
#include "sim/cut/plan/inner_points.h"

namespace kerf::cut {

Wall triangulateWall(const StepInput& in, const Strip& strip, const Outline& outline,
                     const CutCurves& curves) {
    Wall wall;
    const std::vector<CutNode>& nodes = curves.nodes;
    const RestGuess guess(in, strip, curves);
    const PlacesInStrip places(in.blade, strip);
    for (const Sheet2d& loops : nestLoops(in, outline, nodes)) {
        const int piece = loops.outer.front().piece;
        try {
            BorderedSheet sheet(loops, nodes, sizeOf(nodes) + sizeOf(wall.nodes), in.h);
            addInnerPoints(in, guess, places, nodes, sheet);
            clearChords(in, places, sheet);
            wall.sheets.push_back({sheet.triangles(), piece});
            wall.nodes.insert(wall.nodes.end(), sheet.inner().begin(), sheet.inner().end());
        } catch (const StepFailure&) {
            wall.sheets.push_back({cutEars(loops, nodes, in.h), piece});
        }
    }
    return wall;
}

}  // namespace kerf::cut
