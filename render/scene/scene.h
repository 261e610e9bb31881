#pragma once

#include "render/scene/body_look.h"
#include "render/scene/image.h"
#include "render/scene/overlays.h"
#include "render/scene/skin_paint.h"
#include "render/scene/surface_field.h"
#include "sim/base/math.h"
#include "sim/body/skin_normals.h"
#include "sim/contact/blade_body.h"
#include "sim/contact/static_box.h"
#include "sim/cut/blade.h"
#include "sim/solve/body_view.h"

namespace kerf::render {

/// The display of a single piece.
struct PieceLook {
    Eigen::Vector3f tint = Eigen::Vector3f::Zero();  ///< linear albedo
    float strength = 0;                              ///< of the tint, 0 to 1
    bool hidden = false;                             ///< neither drawn nor casting a shadow
    Vec3 shift = Vec3::Zero();                       ///< displacement of its drawing [m]
    bool operator==(const PieceLook&) const = default;
};

/// Everything that a picture shows.
struct SceneView {
    BodyView body;
    /// Changes whenever positions or triangles of the body do, so that shadows and normals are
    /// redrawn; none: always.
    std::optional<int> bodyRevision;
    bool hasWalls = true;  ///< the body may have faces of cuts
    BodyLook look;
    /// The model's own colours, in place of the look's on the skin; null for those of the look. For
    /// the present `body`.
    std::shared_ptr<const SkinPaint> paint;
    FieldView field;                      ///< what the colours of the body show instead of the look
    std::optional<SectionPlane> section;  ///< opens the body
    Bounds restBounds;                    ///< of the uncut rest shape, for the inner structure
    std::vector<StaticBox> boxes;
    std::optional<double> floor;           ///< height of the grid floor [m]
    std::optional<Blade> blade;            ///< steel with a bright edge
    std::optional<BladeMotion> bladeBody;  ///< its true shape if it pushes, at the end of the step
    /// An arrow for the force on the blade, from the middle of its edge [m].
    std::optional<Vec3> bladeForce;
    std::vector<Blade> strokePoses;  ///< that the running stroke has cut: translucent quads
    Bounds focus;                    ///< what the shadow map must cover (body, current)
    bool wireframe = false;
    bool cutLines = false;  ///< a dark line on the skin along the rim of each cut
    /// Faces of the skin that met at more than this angle at rest have a hard edge [degrees].
    double hardEdges = kHardEdgeAngle;
    bool bright = false;  ///< a light backdrop and a light floor
    /// Body, boxes and blade only, on a transparent background, with premultiplied alpha.
    bool transparent = false;
    std::vector<PieceLook> pieces;   ///< by BodyView's pieces; later ones have the default
    std::vector<PixelRect> covered;  ///< by panels: nothing is drawn there, which saves time
    Overlays overlays;
    ConstraintView constraints;         ///< what the overlays show
    std::vector<Bounds> pieceBoxes;     ///< that are drawn around pieces [m]
    std::vector<std::uint32_t> pinned;  ///< vertices that are marked as pinned
    /// Further marks, such as faults; null for none. A change needs another pointer.
    std::shared_ptr<const std::vector<Marks>> marks;
};

/// What the light tier leaves out: multisampling, the soft edge of the shadow, ambient occlusion.
enum class Quality { light, full };

}  // namespace kerf::render
