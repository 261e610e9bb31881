#pragma once

namespace kerf::app {

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
};

}  // namespace kerf::app
