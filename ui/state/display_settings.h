#pragma once

#include <optional>

#include "render/scene/body_look.h"
#include "render/scene/overlays.h"
#include "render/scene/quality.h"
#include "render/scene/section_plane.h"
#include "render/scene/surface_field.h"
#include "sim/body/skin_normals.h"

namespace kerf::ui {

/// The display of the body. It does not affect the simulation.
struct DisplaySettings {
    render::Quality quality = render::Quality::full;
    bool wireframe = false;
    bool cutLines = true;   ///< a dark line along the rim of each cut, so that closed ones show
    bool cutAhead = false;  ///< triangles that a stroke under way will cut
    /// Distance at which the pieces are drawn from each other; 1 doubles that of their middles.
    double apart = 0;
    bool pieceDetails = false;  ///< the list of pieces has all its columns
    render::Overlays overlays;
    render::FieldChoice field;                    ///< shown by its colours instead of the look
    std::optional<render::SectionPlane> section;  ///< opens the view of the body
    render::ChosenColors colors;                  ///< look and colours instead of the model's own
    /// Faces that meet at more than this angle have a hard edge between them [degrees].
    double hardEdges = kHardEdgeAngle;
    bool operator==(const DisplaySettings&) const = default;
};

}  // namespace kerf::ui
