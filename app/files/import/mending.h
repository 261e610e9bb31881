#pragma once

#include <optional>

namespace kerf::app {

/// What is done to a model before it is cut, named among its repairs. In this order.
struct Mending {
    bool repair = false;  ///< see repair::repairSoup(); it fills no holes of what is thickened
    /// The thickness that open sheets are given, in the file's unit; see repair::thicken().
    std::optional<double> thicken = std::nullopt;
    bool fillHoles = false;                     ///< see fillHoles()
    bool remesh = false;                        ///< see repair::remesh()
    std::optional<double> edge = std::nullopt;  ///< that of remesh, in the file's unit

    /// Does this too; lengths that are there win.
    void add(const Mending& more) {
        repair |= more.repair;
        thicken = more.thicken ? more.thicken : thicken;
        fillHoles |= more.fillHoles;
        remesh |= more.remesh;
        edge = more.edge ? more.edge : edge;
    }
    bool operator==(const Mending&) const = default;
};

}  // namespace kerf::app
