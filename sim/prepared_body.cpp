#include "sim/prepared_body.h"

#include "sim/mesh/invariants.h"

namespace kerf {

PreparedBody::PreparedBody(SurfaceMesh uncut, const StageListener& enter)
    : mesh(std::make_unique<SurfaceMesh>(std::move(uncut))) {
    const auto begin = [&](const char* stage) {
        if (enter) {
            enter(stage);
        }
    };
    begin("Building the constraints");
    body = std::make_unique<BodyUpdater>(*mesh);
    begin("Preparing the blade");
    cutter = std::make_unique<Cutter>(*mesh, CutSettings{});
    pages.assign(body->model().pieceOfVertex, body->model().pieces.size());
    closed = checkClosedManifold(*mesh).empty();
}

}  // namespace kerf
