#pragma once

#include "app/files/import/model_units.h"
#include "render/scene/overlays.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/repair/fault_finder.h"

namespace kerf::app {

/// The triangles of a model, and their faults.
struct FoundFaults {
    TriangleSoup soup;  ///< in the file's numbers
    repair::Faults faults;
    std::optional<FileUnits> units = std::nullopt;  ///< that the file names
};

/// "12 open edges": a kind of fault with its count, for people.
std::string labelOf(repair::FaultKind kind, int count);

/// The faults as coloured lines and dots, one for each kind present, in the order of kinds.
/// `cornersOf` returns the vertices of a triangle, or none if it is not to be marked.
std::vector<render::Marks> marksOf(
    const repair::Faults& faults,
    const std::function<std::optional<Triangle>(int triangle)>& cornersOf);
/// Marks of the faults of a soup that have a position.
std::vector<render::Marks> marksOf(const FoundFaults& found);

/// The repairs of a model before it is cut, in this order.
struct Mending {
    bool repair = false;  ///< see repair::repairSoup(); without holes of thickened sheets
    /// The thickness that open sheets are given, in the file's unit; see repair::thicken().
    std::optional<double> thicken = std::nullopt;
    bool fillHoles = false;                     ///< see fillHoles()
    bool remesh = false;                        ///< see repair::remesh()
    std::optional<double> edge = std::nullopt;  ///< that of remesh, in the file's unit

    /// Adds repairs; existing lengths take precedence.
    void add(const Mending& more) {
        repair |= more.repair;
        thicken = more.thicken ? more.thicken : thicken;
        fillHoles |= more.fillHoles;
        remesh |= more.remesh;
        edge = more.edge ? more.edge : edge;
    }
    bool operator==(const Mending&) const = default;

    template <class Io>
    void archive(Io& io) {
        io(repair, thicken, fillHoles, remesh, edge);
    }
};

}  // namespace kerf::app
