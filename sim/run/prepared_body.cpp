#include "sim/run/prepared_body.h"

#include "sim/mesh/invariants.h"

namespace kerf {

PreparedBody::PreparedBody(SurfaceMesh atRest, const StageListener& enter)
    : mesh(std::make_unique<SurfaceMesh>(std::move(atRest))) {
    const auto begin = [&](const char* stage) {
        if (enter) {
            enter(stage);
        }
    };
    begin("Building the constraints");
    body = std::make_unique<BodyUpdater>(*mesh);
    begin("Preparing the blade");
    cutter = std::make_unique<Cutter>(*mesh, CutSettings{});
    cutter->prepare();
    pages.assign(body->model().pieceOfVertex, body->model().pieces.size());
    uncut = std::make_shared<const UncutBody>(
        UncutBody{*mesh, *body, *cutter, checkClosedManifold(*mesh).empty()});
}

}  // namespace kerf
