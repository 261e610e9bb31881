#include "bench/lab/fem/neo_hookean.h"

#include <Eigen/Geometry>
#include <stdexcept>

namespace kerf {

namespace {

/// The derivative of det F by F.
Eigen::Matrix3d cofactors(const Eigen::Matrix3d& f) {
    Eigen::Matrix3d c;
    c.col(0) = f.col(1).cross(f.col(2));
    c.col(1) = f.col(2).cross(f.col(0));
    c.col(2) = f.col(0).cross(f.col(1));
    return c;
}

/// The matrix of v -> a x v.
Eigen::Matrix3d crossWith(const Eigen::Vector3d& a) {
    Eigen::Matrix3d m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}

/// The derivative of cofactors() by F.
NeoHookean::Tangent cofactorTangent(const Eigen::Matrix3d& f) {
    NeoHookean::Tangent t = NeoHookean::Tangent::Zero();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        t.block<3, 3>(3 * i, 3 * j) = -crossWith(f.col(k));
        t.block<3, 3>(3 * i, 3 * k) = crossWith(f.col(j));
    }
    return t;
}

}  // namespace

NeoHookean NeoHookean::of(double youngsModulus, double poissonRatio) {
    if (!(youngsModulus > 0 && poissonRatio > -1 && poissonRatio < 0.5)) {
        throw std::invalid_argument("a solid needs E > 0 and -1 < nu < 0.5");
    }
    return {youngsModulus / (2 * (1 + poissonRatio)),
            youngsModulus * poissonRatio / ((1 + poissonRatio) * (1 - 2 * poissonRatio))};
}

double NeoHookean::energy(const Gradient& f) const {
    const double growth = f.determinant() - 1;
    return shear / 2 * (f.squaredNorm() - 3) - shear * growth +
           (firstLame + shear) / 2 * growth * growth;
}

NeoHookean::Gradient NeoHookean::stress(const Gradient& f) const {
    const double growth = f.determinant() - 1;
    return shear * f + ((firstLame + shear) * growth - shear) * cofactors(f);
}

NeoHookean::Tangent NeoHookean::tangent(const Gradient& f) const {
    const double growth = f.determinant() - 1;
    const Gradient c = cofactors(f);
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> flat(c.data());
    Tangent t = ((firstLame + shear) * growth - shear) * cofactorTangent(f);
    t += (firstLame + shear) * flat * flat.transpose();
    t.diagonal().array() += shear;
    return t;
}

}  // namespace kerf
