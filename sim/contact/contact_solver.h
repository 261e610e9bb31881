#pragma once

#include "gpu/buffer.h"
#include "gpu/kernel_way.h"
#include "gpu/program.h"
#include "shaders/shared/contact_records.h"
#include "sim/base/params.h"
#include "sim/body/body_model.h"
#include "sim/contact/contact_tree.h"

namespace kerf {

/// The buffers of the running body that contact reads and changes: the solver's own.
struct ContactBody {
    const gpu::Buffer* positions = nullptr;     ///< vec4: X [m], w inverse unit mass
    const gpu::Buffer* velocities = nullptr;    ///< vec4 [m/s]
    const gpu::Buffer* displacement = nullptr;  ///< vec4: d of the running substep [m]
    const gpu::Buffer* restPositions = nullptr;
    const gpu::Buffer* links = nullptr;      ///< VertexLinks
    const gpu::Buffer* pieces = nullptr;     ///< PieceRecord
    const gpu::Buffer* triangles = nullptr;  ///< uvec4, see BodyView
    const gpu::Buffer* incidenceRanges = nullptr;
    const gpu::Buffer* incidence = nullptr;
    const gpu::Buffer* columns = nullptr;  ///< IspcConstraint: where material is thin
    const gpu::Buffer* columnRanges = nullptr;
    const gpu::Buffer* columnShares = nullptr;
    std::uint32_t vertexCount = 0;
    std::uint32_t triangleCount = 0;
    std::uint32_t pieceCount = 0;
    const ContactOrder* order = nullptr;  ///< of its search; null: that of their numbers
};

/// How surfaces respond to contact.
struct ContactSettings {
    bool enabled = false;
    bool paper = false;         ///< instead, as PaperContact
    double thickness = 0.05;    ///< distance kept, as a share of the edge length of walls
    double liftSpeed = 1;       ///< at which a sweep resolves penetrations [m/s]
    int sweeps = 1;             ///< of a substep
    double friction = 0.5;      ///< Coulomb coefficient
    double substep = 0;         ///< [s]
    int substeps = 1;           ///< of a time step
    double inverseDensity = 0;  ///< [m^3/kg]
    bool edges = true;          ///< whether edges collide with edges, too

    bool operator==(const ContactSettings&) const = default;
};

ContactSettings contactSettings(const Params& params);

/// The resolution of the fixed-point numbers that sum displacements [m].
double fixedUnit(const ContactSettings& settings);

/// The edge length of walls, the unit of lengths in a contact: that of the skin, at most a twelfth
/// of the diagonal, both of the uncut body (see CutSettings). [m]
double contactEdgeLength(const BodyModel& model);

/// The settings as the kernels read them; counts are 0. `relativeSpeed` [m/s]: an upper bound of
/// how fast two parts of the body approach each other.
shared::ContactUniforms contactUniforms(const ContactSettings& settings, double edgeLength,
                                        double relativeSpeed);

/// The relative motion of the parts of a body.
struct RelativeMotion {
    double speed = 0;  ///< no two vertices differ by more in velocity [m/s]
    /// No two have moved by more relative to each other since candidates were found [m].
    double drift = 0;
    bool touching =
        false;  ///< there are contacts: the nearest triangles must be known, not just some
    bool hasCandidates = true;  ///< false: the last search found none
    bool folded = false;        ///< some edge is folded, so the coming step unfolds (Unfolding)
};

/// The bindings at which a kernel has what it works the answers of contact out in.
struct AnswerBindings {
    std::uint32_t uniforms, records, sums, state;
};

/// The state from which the candidates in force were found; a snapshot keeps it.
struct ContactMemory {
    std::vector<shared::vec4> positions;  ///< X; empty: none were found
    std::vector<shared::vec4> velocities;
    ContactSettings settings;
    shared::ContactUniforms uniforms{};
    RelativeMotion motion;
    /// What contacts push and hold back between implicit steps, row by row; empty: nothing.
    std::vector<shared::vec4> slips;

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(positions, velocities, settings, uniforms, motion, slips);
    }
};

/// Contact of a body with itself, on the GPU: pieces, both walls of a slit, limbs. Vertices against
/// triangles and edges against edges, with the same bits for any number of threads. Candidates are
/// found in a tree of boxes and reused while little moves, else searched once or a few times a time
/// step; in each substep a vertex collides with its nearest one. Without any, a substep dispatches
/// no work.
class ContactSolver {
  public:
    /// Compiles the kernels. Throws gpu::ShaderError.
    ContactSolver();

    /// A new body, or one with a changed rest shape or changed triangles. Throws gpu::OutOfMemory.
    void setBody(const ContactBody& body, double edgeLength);
    void setSettings(const ContactSettings& settings) { settings_ = settings; }
    bool enabled() const { return settings_.enabled; }

    /// For a body that was moved by other means than a step.
    void forgetCandidates() { hasCandidates_ = false; }

    /// The fold of the skin at each vertex, a float each, if the coming step unfolds; else null.
    /// Folded skin does not collide with what was beside it at rest, nor with its own piece.
    void setFolds(const gpu::Buffer* folds) { folds_ = folds; }
    const gpu::Buffer* folds() const { return folds_; }

    /// Begins a time step, before its first substep.
    void beginStep(const RelativeMotion& motion);
    /// Whether there may be contacts before the next search.
    bool mayTouch() const { return enabled() && !foundNone_; }
    /// Whether candidates must be searched before this substep.
    bool searchesBefore(int substep) const {
        return enabled() && !keepsCandidates_ && substep % substepsBetweenSearches_ == 0;
    }
    /// Limits d where it enters another surface, and moves X out of surfaces that it is inside.
    /// `way`: that of the kernels.
    void respond(gpu::KernelWay way);

    /// Binds what respond() works with; contact must be on, and a step begun.
    void bindAnswers(const AnswerBindings& to, gpu::KernelWay way) const;

    /// Searches for candidates now, between substeps.
    void search();
    /// X at the last search; of any size if there was none.
    const gpu::Buffer& searchedPositions() const { return searchedPositions_; }
    /// The state of contact for a snapshot, and its restoring, which continues bit for bit. Call
    /// remember() after setBody().
    ContactMemory memory() const;
    void remember(const ContactMemory& memory);
    /// The candidates found last, nearest first, shape [vertexCount][]; waits for the GPU.
    std::vector<std::vector<shared::ContactCandidate>> readCandidates() const;
    /// Counts of the last search and the last substep.
    const gpu::Buffer& state() const { return state_; }
    /// The contacts of each point in the last substep, shape [state().points]; empty before the
    /// first step with contact.
    const gpu::Buffer& records() const { return records_; }
    shared::ContactState readState() const;
    /// The number of searches so far.
    long searches() const { return searches_; }

  private:
    struct Kernels {
        gpu::Program candidates, detect, respond, respondAgain, apply;
    };
    void takeBody();
    void uploadUniforms();
    void findFromSearched();
    void findCandidates();
    void runIndirect(const gpu::Program& kernel, std::size_t offset);

    Kernels kernels_;
    ContactTree tree_;
    const gpu::Buffer* folds_ = nullptr;
    ContactBody body_;
    ContactSettings settings_;
    double edgeLength_ = 0;
    shared::ContactUniforms uniforms_{};
    int substepsBetweenSearches_ = 1;
    bool keepsCandidates_ = false;       ///< in this step
    bool foundNone_ = false;             ///< there are no candidates
    bool bodyIsNew_ = false;             ///< since the last search
    bool hasCandidates_ = false;         ///< of this body
    ContactSettings candidateSettings_;  ///< with which they were found
    long searches_ = 0;

    gpu::Buffer uniformBuffer_, state_;
    gpu::Buffer searchedPositions_, searchedVelocities_;
    gpu::Buffer normals_, restNormals_;
    gpu::Buffer candidates_, points_, edgePairs_, records_, sums_;
};

}  // namespace kerf
