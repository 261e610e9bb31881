#pragma once

#include "sim/base/math.h"

namespace kerf::render {

/// The parts of the solver that are drawn over the body.
struct Overlays {
    bool edges = false;
    bool bends = false;
    bool ispcs = false;
    bool contacts = false;
    bool boxes = false;  ///< around each piece
    /// Colours edges, bends and ISPCs by their deviation from rest instead of by type; shows edges
    /// if none of the three is chosen.
    bool errors = false;
    bool faults = false;  ///< faults of the model's triangles

    bool showsEdges() const { return edges || (errors && !bends && !ispcs); }
    /// Whether any part of the solver is shown.
    bool any() const { return edges || bends || ispcs || contacts || boxes || errors; }
    bool operator==(const Overlays&) const = default;
};

/// Red, green, blue in display colours, 0 to 255: Okabe and Ito's, which are safe for most colour
/// blindness.
using DisplayColor = std::array<std::uint8_t, 3>;
inline constexpr DisplayColor kEdgeColor{86, 180, 233};
inline constexpr DisplayColor kBendColor{230, 159, 0};
inline constexpr DisplayColor kIspcColor{204, 121, 167};
inline constexpr DisplayColor kContactColor{213, 94, 0};
inline constexpr DisplayColor kBoxColor{0, 158, 115};
inline constexpr DisplayColor kPinColor{240, 228, 66};
// Of errors: shorter or flatter than at rest, at rest, longer or more bent.
inline constexpr DisplayColor kShortColor{0, 114, 178};
inline constexpr DisplayColor kRestColor{235, 235, 235};
inline constexpr DisplayColor kLongColor{213, 94, 0};
/// Errors from here on have the full colour: share of the rest length, or bend [rad].
inline constexpr float kFullError = 0.2F;

/// Lines and dots of one colour over a body, such as one kind of fault of its model. Hidden ones
/// are fainter.
struct Marks {
    std::string label;  ///< what they are, for the legend: "12 open edges"
    DisplayColor color{};
    std::vector<std::uint32_t> lines;  ///< pairs of vertices of the body
    std::vector<std::uint32_t> dots;   ///< vertices of the body

    bool operator==(const Marks&) const = default;
};

/// A plane that opens the view of the body, without cutting it.
struct SectionPlane {
    Vec3 point = Vec3::Zero();    ///< on the plane [m]
    Vec3 normal = Vec3::UnitZ();  ///< unit; the body is hidden on its side
    bool operator==(const SectionPlane&) const = default;

    /// The distance of a point on the hidden side [m]; negative on the other.
    double distance(const Vec3& at) const { return normal.dot(at - point); }
};

}  // namespace kerf::render
