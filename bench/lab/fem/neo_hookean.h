#pragma once

#include <Eigen/Core>

namespace kerf {

/// An elastic solid of finite strains, the stable neo-Hookean one (Smith, de Goes, Kim 2018)
/// without its barrier: mu/2 (tr(F^T F) - 3) - mu (J - 1) + (lambda + mu)/2 (J - 1)^2 for the
/// deformation gradient F and J = det F. It rests at F = 1, obeys Hooke's law there, and stays
/// finite where a tetrahedron is flat or inside out.
struct NeoHookean {
    double shear = 0;      ///< mu [Pa]
    double firstLame = 0;  ///< lambda [Pa]

    using Gradient = Eigen::Matrix3d;  ///< F, or what is taken by F
    /// What is taken by F twice; rows and columns number the columns of F one after another.
    using Tangent = Eigen::Matrix<double, 9, 9>;

    /// The solid of this Young's modulus [Pa] and Poisson's ratio, which must be below 0.5.
    static NeoHookean of(double youngsModulus, double poissonRatio);

    /// Energy for each volume of the unstrained solid [J/m^3].
    double energy(const Gradient& f) const;
    /// First Piola-Kirchhoff stress, the derivative of the energy by F [Pa].
    Gradient stress(const Gradient& f) const;
    /// The derivative of the stress by F [Pa]. Symmetric; indefinite where the solid is squeezed.
    Tangent tangent(const Gradient& f) const;
};

}  // namespace kerf
