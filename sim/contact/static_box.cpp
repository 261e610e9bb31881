#include "sim/contact/static_box.h"

#include "sim/base/placement.h"

namespace kerf {

namespace {

bool within(const Vec3& value, double low, double high) {
    return value.allFinite() && value.minCoeff() >= low && value.maxCoeff() <= high;
}

}  // namespace

Eigen::Matrix3d StaticBox::axes() const {
    return turnOf(rotate);
}

Vec3 StaticBox::corner(int index) const {
    return center + axes() * Bounds{-0.5 * size, 0.5 * size}.corner(index);
}

Bounds StaticBox::bounds() const {
    const Vec3 reach = 0.5 * (axes().cwiseAbs() * size);
    return {center - reach, center + reach};
}

std::string checkBox(const StaticBox& box) {
    if (!within(box.center, -kFarthestBox, kFarthestBox)) {
        return "The centre of a box needs three numbers from -1e8 to 1e8 m.";
    }
    if (!within(box.size, kLeastBoxSize, kLargestBoxSize)) {
        return "The size of a box needs three numbers from 1e-6 to 1e6 m.";
    }
    if (!within(box.rotate, -kLargestBoxTurn, kLargestBoxTurn)) {
        return "The rotation of a box needs three numbers from -36000 to 36000 degrees.";
    }
    return "";
}

}  // namespace kerf
