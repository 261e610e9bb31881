#pragma once

#include <optional>
#include <vector>

#include "sim/cut/cleanup/copies.h"

namespace kerf::cut {

/// Tells which copies of a point merge into which copies of its neighbour.
struct CopyPairing {
    std::vector<int> edges;     ///< half-edges from the copy that goes to the one that stays
    std::vector<int> unpaired;  ///< copies without an edge to the neighbour

    /// Whether every copy of either point has a partner of its own.
    bool isOneToOne(const SharedStar& from, const SharedStar& to) const {
        return unpaired.empty() && from.copies.size() == to.copies.size() &&
               edges.size() == to.copies.size();
    }
};

/// Pairs the copies of two neighbours along their edges. Nothing where a copy has several partners
/// (the slit would close) or no copy has one.
std::optional<CopyPairing> pairCopies(const SurfaceMesh& mesh, const SharedStar& from,
                                      const SharedStar& to);

/// Whether the link condition holds with all slits closed: common neighbours are apexes of the
/// shared edge, and no two features fall into one.
bool keepsSharedComplex(const SharedStar& from, const SharedStar& to);

/// Whether the mesh stays a simple complex (I3) after the collapse of these half-edges, one after
/// the other, and every apex keeps three triangles.
bool keepsMeshComplex(const SurfaceMesh& mesh, const std::vector<int>& edges);

/// Collapses half-edge h: its origin's triangles become its target's, two triangles go. Returns
/// those two; the origin has no triangle afterwards.
std::array<int, 2> collapseHalfEdge(SurfaceMesh& mesh, int h);

}  // namespace kerf::cut
