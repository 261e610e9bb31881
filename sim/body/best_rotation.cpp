#include "sim/body/best_rotation.h"

#include <Eigen/SVD>

namespace kerf {

Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& covariance) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d product = svd.matrixU() * svd.matrixV().transpose();
    const Vec3 signs(1, 1, product.determinant() < 0 ? -1 : 1);
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace kerf
