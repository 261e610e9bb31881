#include "app/import/piece_union.h"

#include <spdlog/fmt/fmt.h>

#include "app/files/import/import_process.h"
#include "app/files/import/shell_protocol.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/files/jobs/child_process.h"
#include "sim/base/containers.h"
#include "sim/base/text.h"
#include "sim/mesh/skin_attributes.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/union_find.h"
#include "sim/repair/crossings.h"
#include "sim/repair/shell_nesting.h"
#include "sim/repair/soup_editing.h"
#include "sim/repair/soup_inspection.h"
#include "sim/repair/soup_repair.h"

namespace kerf::app {

namespace {

const std::string kFallsTogether =
    "rounded to the 32-bit numbers of a file, their union is no closed surface";
constexpr std::size_t kMostCrossings = 2'000'000;
constexpr ImportLimits kLimits{.cpuSeconds = 120, .wallSeconds = 240, .addressSpace = 8ull << 30};

/// The pieces of a soup, by the numbers of their outer shells, and which of them cross.
class CrossingPieces {
  public:
    explicit CrossingPieces(const TriangleSoup& soup);

    /// Groups of at least two pieces that are to become one, each ascending.
    std::vector<std::vector<int>> groups() const;
    /// How many pieces pass through themselves.
    int crossingThemselves() const {
        return static_cast<int>(std::ranges::count(crossesItself_, 1));
    }
    int pieceOf(int triangle) const { return ofTriangle_[triangle]; }

  private:
    std::vector<int> ofTriangle_;
    std::vector<char> crossesItself_;  ///< by piece
    UnionFind groups_;                 ///< of pieces
};

CrossingPieces::CrossingPieces(const TriangleSoup& soup) : groups_(0) {
    const repair::SoupShells shells = repair::measureShells(soup);
    const repair::ShellNesting nesting = repair::nestShells(soup, shells);
    ofTriangle_.reserve(soup.triangles.size());
    for (const int shell : shells.ofTriangle) {
        ofTriangle_.push_back(nesting.owner[shell]);
    }
    crossesItself_.assign(shells.size(), 0);
    groups_ = UnionFind(shells.size());
    const auto crossings = repair::findCrossings(soup, kMostCrossings);
    for (const auto& [first, second] : crossings) {
        if (pieceOf(first) == pieceOf(second)) {
            crossesItself_[pieceOf(first)] = 1;
        }
    }
    for (const auto& [first, second] : crossings) {
        const int a = pieceOf(first);
        const int b = pieceOf(second);
        if (a != b && crossesItself_[a] == 0 && crossesItself_[b] == 0) {
            groups_.join(a, b);
        }
    }
}

std::vector<std::vector<int>> CrossingPieces::groups() const {
    std::map<int, std::vector<int>> all;  // by their lowest piece
    UnionFind sets = groups_;
    for (int piece = 0; piece < static_cast<int>(crossesItself_.size()); ++piece) {
        all[sets.root(piece)].push_back(piece);
    }
    std::vector<std::vector<int>> groups;
    for (auto& [root, group] : all) {
        if (group.size() > 1) {
            groups.push_back(std::move(group));
        }
    }
    return groups;
}

ShellMessage messageOf(const TriangleSoup& soup, const CrossingPieces& pieces,
                       const std::vector<int>& group) {
    ShellMessage message;
    message.positions.reserve(soup.positions.size());
    for (const Vec3& p : soup.positions) {
        message.positions.push_back({p.x(), p.y(), p.z()});
    }
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        const auto found = std::ranges::lower_bound(group, pieces.pieceOf(t));
        if (found != group.end() && *found == pieces.pieceOf(t)) {
            message.triangles.push_back(soup.triangles[t]);
            message.pieces.push_back(static_cast<int>(found - group.begin()));
        }
    }
    return message;
}

/// The answer of kerf-unite, or one with the reason why there is none.
ShellMessage askForUnion(const ShellMessage& pieces, WorkProgress* progress) {
    const std::filesystem::path program = programBeside("kerf-unite");
    if (!std::filesystem::exists(program)) {
        return {.failure = "the program kerf-unite is not installed"};
    }
    const TemporaryFolder folder("kerf-unite");
    const std::filesystem::path file = folder.path() / "pieces";
    writeOutputFile(file, encodeShells(pieces));
    const ImportOutcome outcome =
        runLimitedProcess({program.string(), file.string()}, kLimits, progress);
    if (outcome.tooSlow) {
        return {.failure = "it takes more than two minutes"};
    }
    std::optional<ShellMessage> answer = decodeShells(outcome.answer);
    if (outcome.exitCode != 0 || !answer) {
        return {.failure = "kerf-unite failed"};
    }
    return std::move(*answer);
}

/// A group of pieces as one surface.
struct United {
    std::vector<int> group;
    TriangleSoup surface;
};

/// A surface as a file of floats holds it, mended where it falls together; nothing where that
/// leaves none of its volume that can be cut.
std::optional<TriangleSoup> soundSurface(const ShellMessage& exact) {
    constexpr double kMostLost = 1e-3;  // of the volume
    TriangleSoup surface;
    for (const auto& [x, y, z] : exact.positions) {
        surface.positions.emplace_back(x, y, z);
    }
    surface.triangles.assign(exact.triangles.begin(), exact.triangles.end());
    const double volume = inspectTriangles(surface).volume;
    roundToFloats(surface);
    if (!inspectTriangles(surface).cuttable) {
        repair::repairSoup(surface);
    }
    const MeshReport found = inspectTriangles(surface);
    const bool whole = std::abs(found.volume - volume) <= kMostLost * std::abs(volume);
    return found.cuttable && whole ? std::optional(std::move(surface)) : std::nullopt;
}

/// By triangle: whether its piece is in none of these groups.
std::vector<char> outside(const std::vector<United>& all, const CrossingPieces& pieces,
                          std::size_t triangles) {
    std::vector<char> keep(triangles, 1);
    for (const United& united : all) {
        for (int t = 0; t < static_cast<int>(triangles); ++t) {
            keep[t] = std::ranges::binary_search(united.group, pieces.pieceOf(t)) ? 0 : keep[t];
        }
    }
    return keep;
}

void append(const TriangleSoup& surface, SkinCarrier& carrier, int uncutSlots, TriangleSoup& soup) {
    const auto first = static_cast<int>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), surface.positions.begin(), surface.positions.end());
    for (const auto& [a, b, c] : surface.triangles) {
        const Triangle t{first + a, first + b, first + c};
        const auto slot = static_cast<int>(soup.triangles.size());
        soup.triangles.push_back(t);
        resizeAttributes(soup.skin, soup.triangles.size());
        setAttributes(soup.skin, slot,
                      carrier.of(uncutSlots, {soup.positions[t[0]], soup.positions[t[1]],
                                              soup.positions[t[2]]}));
    }
}

/// The soup with all groups exchanged for their surfaces.
TriangleSoup exchanged(const TriangleSoup& soup, const CrossingPieces& pieces,
                       const std::vector<United>& all) {
    const SurfaceMesh before = SurfaceMesh::fromTriangles(soup.positions, soup.triangles);
    SkinCarrier carrier(before, soup.skin);
    TriangleSoup now = soup;
    for (const United& united : all) {
        append(united.surface, carrier, before.triangleSlots(), now);
    }
    std::vector<char> keep = outside(all, pieces, soup.triangles.size());
    keep.resize(now.triangles.size(), 1);
    repair::keepTriangles(now, [&](int t) { return keep[t] != 0; });
    repair::dropUnusedVertices(now);
    return now;
}

std::string textOf(const std::vector<int>& group) {
    return counted(static_cast<int>(group.size()), "piece", "pieces");
}

std::string notUnited(std::string_view which, std::string_view why) {
    return fmt::format(
        "{} that cross were not united: {}; move one of them a little, or unite them in a "
        "modelling tool",
        which, why);
}

}  // namespace

ShellUnion uniteCrossingPieces(TriangleSoup& welded, WorkProgress* progress) {
    enter(progress, "Looking for pieces that cross");
    ShellUnion outcome;
    const CrossingPieces pieces(welded);
    if (const int count = pieces.crossingThemselves(); count > 0) {
        outcome.left.push_back(
            counted(count, "piece passes through itself", "pieces pass through themselves") +
            ", which no repair here mends; mend it in a modelling tool");
    }
    std::vector<United> all;
    for (const std::vector<int>& group : pieces.groups()) {
        enter(progress, "Uniting pieces that cross");
        const ShellMessage answer = askForUnion(messageOf(welded, pieces, group), progress);
        std::optional<TriangleSoup> surface =
            answer.failure.empty() ? soundSurface(answer) : std::nullopt;
        if (surface) {
            outcome.done.push_back("united " + textOf(group) + " that crossed");
            all.push_back({group, std::move(*surface)});
        } else {
            outcome.left.push_back(
                notUnited(textOf(group), answer.failure.empty() ? kFallsTogether : answer.failure));
        }
    }
    if (all.empty()) {
        return outcome;
    }
    TriangleSoup now = exchanged(welded, pieces, all);
    if (!inspectTriangles(now).cuttable) {
        outcome.done.clear();
        outcome.left.push_back(
            notUnited("pieces", "what their union surrounds faces the wrong way then"));
        return outcome;
    }
    welded = std::move(now);
    return outcome;
}

std::vector<std::string> unionsToMake(const TriangleSoup& welded) {
    return mapped(CrossingPieces(welded).groups(), [](const std::vector<int>& group) {
        return "unite " + textOf(group) + " that cross";
    });
}

}  // namespace kerf::app
