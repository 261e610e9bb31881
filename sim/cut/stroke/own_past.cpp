#include "sim/cut/stroke/own_past.h"

namespace kerf::cut {

namespace {

constexpr double kPast = 3;  // edge lengths behind the front: farther than what it may crumple

}  // namespace

void OwnPast::start(int firstVertex) {
    *this = {};
    past_ = {firstVertex, firstVertex};
}

void OwnPast::closeUp(int endVertex) {
    past_.end = endVertex;
    recent_.clear();
}

void OwnPast::goOn(double way, int nextVertex) {
    recent_.push_back({way_, nextVertex});
    way_ += way;
    auto present = recent_.begin();
    while (present != recent_.end() && present->way + kPast <= way_) {
        past_.end = present->nextVertex;
        ++present;
    }
    recent_.erase(recent_.begin(), present);
}

}  // namespace kerf::cut
