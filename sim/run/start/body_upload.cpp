#include "sim/run/start/body_upload.h"

#include <cassert>

namespace kerf {

BodyUpload::BodyUpload(PreparedBody prepared)
    : prepared_(std::move(prepared)),
      state_(stateOf(prepared_.uncut->mesh)),
      solver_(std::make_unique<GpuSolver>()) {}

void BodyUpload::advance() {
    assert(!done());
    solver_->setModelPortion(next_, prepared_.body->model(), state_, prepared_.pages);
    ++next_;
}

void BodyUpload::finish() {
    while (!done()) {
        advance();
    }
}

}  // namespace kerf
