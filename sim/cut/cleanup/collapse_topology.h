#pragma once

#include <optional>
#include <vector>

#include "sim/cut/cleanup/material.h"

namespace kerf::cut {

/// Which copies of a point merge into which copies of its neighbour.
struct CopyPairing {
    std::vector<int> edges;     ///< half-edges from the copy that goes to the one that stays
    std::vector<int> unpaired;  ///< copies without an edge to the neighbour

    bool isOneToOne(const MaterialStar& from, const MaterialStar& to) const {
        return unpaired.empty() && from.copies.size() == to.copies.size() &&
               edges.size() == to.copies.size();
    }
};

/// None where a copy has no unique partner (that would close the slit) or no copy has one.
std::optional<CopyPairing> pairCopies(const SurfaceMesh& mesh, const MaterialStar& from,
                                      const MaterialStar& to);

/// The link condition on material points: common neighbours are apexes of the edge, and no two
/// features fall into one.
bool keepsMaterialComplex(const MaterialStar& from, const MaterialStar& to);

/// The mesh stays a simple complex (I3) after the collapse of these half-edges, one after the
/// other, and every apex keeps three triangles.
bool keepsMeshComplex(const SurfaceMesh& mesh, const std::vector<int>& edges);

/// Collapses half-edge h: its origin's triangles become its target's, two triangles go. Returns
/// those two; the origin has no triangle afterwards.
std::array<int, 2> collapseHalfEdge(SurfaceMesh& mesh, int h);

}  // namespace kerf::cut
