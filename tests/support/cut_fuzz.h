#pragma once

#include "tests/support/cut_strokes.h"

namespace kerf::test {

/// What a random stroke is like.
enum class FuzzMode {
    straight,    ///< right through
    curved,      ///< right through on a bent path
    twisted,     ///< right through, the blade turns about its path
    fast,        ///< right through, many edge lengths a step
    aligned,     ///< right through in axis directions, through a vertex or along an edge
    crossing,    ///< several strokes right through, one after the other
    realigned,   ///< several aligned strokes, also exactly along older slits
    concurrent,  ///< three strokes through one line
    incision,    ///< the tip stays inside
    wander,      ///< the tip turns and changes depth
    pivot,       ///< about the tip inside
    saw,         ///< forwards while sliding along its axis
    reverse,     ///< goes back and forth
    deform,      ///< the body moves smoothly while it is cut
    rocking,     ///< right through, one end of the blade going on while the other goes back
    slicing,     ///< right through, drawn to and fro along itself, a little deeper each step
};
inline constexpr int kFuzzModes = 16;
/// Of them, those that seeds draw: the others only where KERF_FUZZ_MODE asks for them.
inline constexpr int kModesDrawn = 14;
const char* nameOf(FuzzMode mode);
/// The stroke passes the whole body, so it must leave no slit that ends inside.
bool goesThrough(FuzzMode mode);

/// The stroke leaves slabs thinner than any sliver by its nature: it runs along an older slit, or
/// its own, or through a line that other slits share.
bool leavesSlabs(FuzzMode mode);

struct FuzzFigures {
    int strokes = 0;
    int cuts = 0;
    int refused = 0;
    int retried = 0;
    int resumed = 0;      ///< steps that let go of the front and cut anew from behind it
    int unseparated = 0;  ///< strokes right through after which a piece lies on both sides
    int slitEnds = 0;     ///< strokes right through that left the end of a slit inside the body
    int unmirrored = 0;   ///< strokes after which some wall triangle has no mirror
    /// Strokes after which the mesh passes through itself where all slits are opened by 1e-6 h, and
    /// did not before.
    int intersecting = 0;
    int outside = 0;  ///< strokes that left a wall vertex outside the box of the skin, at rest
    int invalid = 0;  ///< strokes in which an invariant broke
    StrokeQuality quality;        ///< of the new triangles after each stroke
    double mostVolumeChange = 0;  ///< of a stroke, relative
    CleanupStatistics cleanup;
    std::vector<std::string> notes;  ///< one line for each stroke worth looking at
};

/// How positions and the blade's offset are.
enum class FuzzSetting {
    exact,    ///< positions stay doubles
    fine,     ///< doubles, and the blade's offset is 1e-7 h
    rounded,  ///< moved by up to 1e-6 h and rounded to floats every step
};
inline constexpr std::array kFuzzSettings{FuzzSetting::exact, FuzzSetting::fine,
                                          FuzzSetting::rounded};

struct FuzzReport {
    /// By setting, then by mode.
    std::array<std::array<FuzzFigures, kFuzzModes>, kFuzzSettings.size()> figures;
    std::string table() const;
    FuzzFigures total(FuzzSetting setting) const;
    /// All modes that leave no slabs.
    FuzzFigures ordinary(FuzzSetting setting) const;
    FuzzFigures& of(FuzzSetting setting, FuzzMode mode) {
        return figures[static_cast<int>(setting)][static_cast<int>(mode)];
    }
    const FuzzFigures& of(FuzzSetting setting, FuzzMode mode) const {
        return figures[static_cast<int>(setting)][static_cast<int>(mode)];
    }
};

/// One random body and its strokes; `seed` decides everything, but for the kind of stroke where one
/// is `wanted`. `velocity`: that of all vertices [m/s]; nothing goes anywhere by it.
void fuzzOnce(std::uint64_t seed, FuzzReport& report, std::optional<FuzzMode> wanted = {},
              const Vec3& velocity = Vec3::Zero());

}  // namespace kerf::test
