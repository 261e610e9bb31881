#include "sim/run/prepared_body.h"

#include "sim/mesh/invariants.h"

namespace kerf {

UncutBody makeUncutBody(SurfaceMesh& atRest, const Placement& placement,
                        const StageListener& enter) {
    const auto begin = [&](const char* stage) {
        if (enter) {
            enter(stage);
        }
    };
    begin("Building the constraints");
    BodyUpdater body(atRest);
    begin("Preparing the blade");
    Cutter cutter(atRest, CutSettings{});
    cutter.prepare();
    return {atRest, std::move(body), std::move(cutter), checkClosedManifold(atRest).empty(),
            placement};
}

PreparedBody::PreparedBody(SurfaceMesh atRest, const StageListener& enter,
                           const Placement& placement)
    : mesh(std::make_unique<SurfaceMesh>(std::move(atRest))),
      uncut(std::make_shared<const UncutBody>(makeUncutBody(*mesh, placement, enter))) {
    body = std::make_unique<BodyUpdater>(uncut->body);
    cutter = std::make_unique<Cutter>(uncut->cutter);
    pages.assign(body->model().pieceOfVertex, body->model().pieces.size());
}

}  // namespace kerf
