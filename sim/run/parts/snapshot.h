#pragma once

#include "sim/body/body_updater.h"
#include "sim/contact/contact_solver.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/run/parts/cohesive_zone.h"
#include "sim/run/parts/hands.h"
#include "sim/run/parts/pins.h"
#include "sim/run/parts/shape_recovery.h"
#include "sim/run/parts/step_report.h"
#include "sim/run/start/prepared_body.h"
#include "sim/solve/body_measure.h"
#include "sim/solve/implicit/step_choice.h"
#include "sim/solve/volume_targets.h"

namespace kerf {

/// The stroke of a tear, which goes on while it advances.
struct TearStroke {
    bool goesOn = false;       ///< the cutter's stroke is a tear
    int firstVertex = 0;       ///< those from here on are of the tear
    int idle = 0;              ///< steps since it last advanced
    int rest = 0;              ///< steps until what is stuck is tried again
    std::vector<int> stuck{};  ///< first vertices of ends that could not advance

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(goesOn, firstVertex, idle, rest, stuck);
    }
};

/// The state of a body besides mesh, model, cutter and GPU.
struct BodyMemory {
    VolumeTargets volumeTargets;
    Hands hands;
    Pins pins;
    ShapeRecovery recovery;
    CohesiveZone cohesion;  ///< of tears
    TearStroke tear;
    BodyMeasure measure;  ///< after the last step
    EnergyGuard guard;    ///< of implicit steps
    SubdivisionCounts subdivisions{};
    std::vector<StrokeRecord> strokes;  ///< since the body was whole; see Simulation::strokes()
    /// Parameters keep no shape, or were changed while it was folded: inverted parts may stay so.
    bool mayHaveCollapsed = false;
    /// Some piece was partly inside out, and something has been folded since.
    bool crumpled = false;
    double stillFor = 0;  ///< time at rest without a disturbance [s]
    int foldedSteps = 0;  ///< without a stroke, since its shape was last checked
    int mendings = 0;     ///< of folds, that the last stroke may still ask for
    bool closed = true;   ///< no cut has left a defect; see checkClosedManifold

    /// Adds a stroke, replacing one that did not meet the body.
    void beginStroke(const StrokeRecord& stroke) {
        if (strokes.empty() || strokes.back().metBody()) {
            strokes.emplace_back();
        }
        strokes.back() = stroke;
    }

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(volumeTargets, hands, pins, recovery, cohesion, tear, measure, guard, subdivisions,
           strokes, mayHaveCollapsed, crumpled, stillFor, foldedSteps, mendings, closed);
    }
};

/// The body of a simulation between two steps, with the state of cutting and solving. A restored
/// one continues bit for bit. Body, cutter and trees refer to the mesh of the simulation that made
/// it, so only that one can use it, and it must not outlive it.
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
