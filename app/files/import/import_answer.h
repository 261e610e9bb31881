#pragma once

#include "app/files/import/model_faults.h"
#include "app/files/import/model_units.h"
#include "app/files/io/memory_means.h"
#include "render/scene/appearance.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/repair/soup_inspection.h"

namespace kerf::app {

/// Largest model file that is read [bytes].
inline constexpr std::uintmax_t kMaxModelBytes = 1'000'000'000;
/// Most vertices and triangles that a model file may hold.
inline constexpr std::uint64_t kMaxImportVertices = 60'000'000;
inline constexpr std::uint64_t kMaxImportTriangles = 20'000'000;
/// Least and largest extent of a model, in the unit of its numbers.
inline constexpr double kMinImportExtent = 1e-6;
inline constexpr double kMaxImportExtent = 1e10;
/// Most bytes of the images of a model together.
inline constexpr std::uint64_t kMaxImportImages = 500'000'000;

/// A model as read from its file.
struct ImportedModel {
    TriangleSoup soup;
    FileFacts facts{};  ///< objects by their numbers in the soup
    render::Appearance appearance{};
    std::vector<std::string> remarks{};  ///< sentences about what was skipped

    template <class Io>
    void archive(Io& io) {
        io(soup, facts, appearance, remarks);
    }
};

/// The repairs that would fix a model.
struct ModelHelp {
    int holes = 0;                     ///< number to fill; 0 if that does not help
    std::vector<std::string> repairs;  ///< what a repair would do; empty if it does not help
    double thickness = 0;              ///< of its sheets, in the file's unit; 0 if it does not help
    bool isSheet = false;  ///< see repair::isSheet(); else filling or a repair is better

    template <class Io>
    void archive(Io& io) {
        io(holes, repairs, thickness, isSheet);
    }
};

/// What is wanted of a model file.
struct ImportOrder : Mending {
    int object = 0;           ///< the number of the only object to read, from 1; 0: all
    bool toFile = false;      ///< rounds to the floats of a file, and refuses what fails then
    bool findFaults = false;  ///< each with its place
    bool tryRepair = false;   ///< finds out what would help a model that can't be cut: takes long
    /// Intersecting triangles are counted in models of at most this many triangles.
    std::size_t findCrossingsUpTo = 0;
    /// The memory for cutting the model: one that exceeds it is not read.
    std::optional<MemoryMeans> means = std::nullopt;

    template <class Io>
    void archive(Io& io) {
        Mending::archive(io);
        io(object, toFile, findFaults, tryRepair, findCrossingsUpTo, means);
    }
};

/// How a model file was received.
enum class ImportOutcome {
    cuttable,
    faulty,      ///< read, and can't be cut
    refused,     ///< not read
    outOfMemory  ///< there is too little memory to cut it
};
inline constexpr int kImportOutcomes = 4;

/// The answer of kerf-import.
struct ImportAnswer {
    ImportOutcome outcome = ImportOutcome::refused;
    /// Why it is not cuttable: a clause, or a sentence that names the file if it is out of memory.
    std::string reason;
    ImportedModel model{};  ///< images are decoded; empty if it was not read
    MeshReport report{};
    repair::Faults faults{};  ///< if they were asked for
    ModelHelp help{};         ///< if it was asked for

    template <class Io>
    void archive(Io& io) {
        io(outcome, reason, model, report, faults, help);
    }
};

/// An order as letters, for a command line.
std::string encodeOrder(const ImportOrder& order);
/// Throws InputError if the letters are no order.
ImportOrder decodeOrder(std::string_view letters);

std::string encodeAnswer(const ImportAnswer& answer);
/// Decodes `count` answers, one after the other, and trusts nothing in them: lengths, counts, kinds
/// and indices are checked; texture coordinates and colours that are not finite become 0. Throws
/// InputError with a clause.
std::vector<ImportAnswer> decodeAnswers(std::string_view bytes, std::size_t count = 1);

}  // namespace kerf::app
