#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/body/body_updater.h"
#include "sim/contact/contact_solver.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/run/parts/hands.h"
#include "sim/run/parts/pins.h"
#include "sim/run/parts/shape_recovery.h"
#include "sim/run/parts/stroke_record.h"
#include "sim/run/start/prepared_body.h"
#include "sim/solve/body_measure.h"
#include "sim/solve/volume_targets.h"

namespace kerf {

/// What a simulation remembers of its body beside mesh, model, cutter and GPU.
struct BodyMemory {
    VolumeTargets volumeTargets;
    Hands hands;
    Pins pins;
    ShapeRecovery recovery;
    BodyMeasure measure;  ///< as of the last step
    SubdivisionCounts subdivisions{};
    std::vector<StrokeRecord> strokes;  ///< since the body was whole; see Simulation::strokes()
    /// Parameters keep no shape, or were changed while it was folded: what they have turned inside
    /// out stays so.
    bool mayHaveCollapsed = false;
    /// Some piece was partly inside out, and something has been folded since.
    bool crumpled = false;
    double stillFor = 0;  ///< time over which it has hardly moved, and nothing was done to it [s]
    int foldedSteps = 0;  ///< without a stroke, since its shape was last looked at
    bool closed = true;   ///< no cut has left a defect; see checkClosedManifold

    /// Remembers a stroke, in the place of one before it that did not meet the body.
    void beginStroke(const StrokeRecord& stroke) {
        if (strokes.empty() || strokes.back().metBody()) {
            strokes.emplace_back();
        }
        strokes.back() = stroke;
    }
};

/// The body of a simulation between two steps, and all that cutting and solving remember of it. One
/// that is restored goes on bit for bit as it would have. Body, cutter and trees refer to the mesh
/// of the simulation that made it, so it is of use to that one alone and must not outlive it.
struct Snapshot {
    SurfaceMesh mesh;  ///< with the positions and velocities of the GPU
    BodyUpdater body;
    Cutter cutter;
    VertexPages pages;
    BodyMemory memory;
    ContactMemory contact;
    std::shared_ptr<const UncutBody> uncut;  ///< what it was made of; never null
};
using SnapshotPointer = std::shared_ptr<const Snapshot>;

/// About how much memory a snapshot of such a body takes [bytes]: measured per vertex and triangle
/// slot, the same on every machine.
std::size_t snapshotBytes(const SurfaceMesh& mesh);

}  // namespace kerf
