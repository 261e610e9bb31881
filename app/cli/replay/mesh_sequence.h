#pragma once

#include "app/files/export/export_mesh.h"
#include "app/files/export/mesh_formats.h"
#include "app/files/io/output_folder.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// The meshes of a run to write.
struct SequenceOptions {
    int every = 0;  ///< steps from one to the next; 0 for no sequence
    MeshFormat format = MeshFormat::ply;
};

/// The folder of a sequence, in that of the results.
inline constexpr const char* kSequenceFolder = "sequence";

/// Writes a mesh of a body every few steps, and lists of them for other programs.
class MeshSequence {
  public:
    /// Removes the meshes of an earlier run. Throws OutputError, like all functions here.
    MeshSequence(OutputFolder& folder, const SequenceOptions& options);

    /// Whether the state before a step is one of the sequence; `last` is the step behind the run.
    bool wants(int step, int last) const;
    /// Writes the state before a step, at simulated `time` [s], with positions relative to `from`.
    void write(int step, double time, const SurfaceMesh& mesh, const PieceMap& pieces,
               const ExportLooks& looks, const Vec3& from);
    /// Writes the lists: sequence.EXTENSION.series, and sequence.pvd of .vtp files.
    void finish();

  private:
    void removeEarlier();

    struct Entry {
        std::string file;  ///< without its folder
        double time = 0;   ///< simulated [s]
    };

    OutputFolder& folder_;
    SequenceOptions options_;
    std::vector<Entry> entries_;
};

}  // namespace kerf::app
