#include "app/import/piece_union.h"

// What CGAL's union is linked into is under the GPL: so is kerf-import, a program of its own.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <spdlog/fmt/fmt.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <list>

#include "app/files/io/system_file.h"
#include "app/files/jobs/process_limits.h"
#include "app/import/mending.h"
#include "app/import/repair/soup_repair.h"
#include "sim/base/byte_archive.h"
#include "sim/base/containers.h"
#include "sim/base/text.h"
#include "sim/mesh/skin_attributes.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/union_find.h"
#include "sim/repair/crossings.h"
#include "sim/repair/shell_nesting.h"
#include "sim/repair/soup_editing.h"
#include "sim/repair/soup_inspection.h"

namespace kerf::app {

namespace {

const std::string kFallsTogether =
    "rounded to the 32-bit numbers of a file, their union is no closed surface";
constexpr std::size_t kMostCrossings = 2'000'000;
constexpr int kUnionSeconds = 120;

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

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// A surface that may not exist.
struct UnionAnswer {
    std::string failure = {};  ///< why there is none, a clause
    std::vector<Vec3> positions = {};
    std::vector<Triangle> triangles = {};

    template <class Io>
    void archive(Io& io) {
        io(failure, positions, triangles);
    }
};

ExactMesh meshOf(const TriangleSoup& soup, const CrossingPieces& pieces, int piece) {
    ExactMesh mesh;
    std::map<int, ExactMesh::Vertex_index> vertices;
    const auto vertexFor = [&](int v) {
        const auto found = vertices.find(v);
        if (found != vertices.end()) {
            return found->second;
        }
        const Vec3& p = soup.positions[v];
        return vertices.emplace(v, mesh.add_vertex({p.x(), p.y(), p.z()})).first->second;
    };
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        if (pieces.pieceOf(t) != piece) {
            continue;
        }
        const auto& [a, b, c] = soup.triangles[t];
        if (mesh.add_face(vertexFor(a), vertexFor(b), vertexFor(c)) == ExactMesh::null_face()) {
            throw std::runtime_error("a piece is not manifold");
        }
    }
    if (!pmp::does_bound_a_volume(mesh)) {
        throw std::runtime_error("a piece encloses no volume");
    }
    return mesh;
}

/// Whether `whole` became one surface with the piece; else it stays as it was.
bool unite(ExactMesh& whole, ExactMesh piece) {
    ExactMesh before = whole;
    if (pmp::corefine_and_compute_union(whole, piece, whole,
                                        CGAL::parameters::throw_on_self_intersection(true))) {
        return true;
    }
    whole = std::move(before);
    return false;
}

/// Kernel numbers are exact, so that the result of one union can go into the next. What would touch
/// in a line or a point alone waits for the others, which may fill the place.
ExactMesh united(const TriangleSoup& soup, const CrossingPieces& pieces,
                 const std::vector<int>& group) {
    ExactMesh whole = meshOf(soup, pieces, group.front());
    std::list<ExactMesh> waiting;
    for (const int piece : std::span(group).subspan(1)) {
        waiting.push_back(meshOf(soup, pieces, piece));
    }
    while (!waiting.empty()) {
        if (waiting.remove_if([&](const ExactMesh& piece) { return unite(whole, piece); }) == 0) {
            throw std::runtime_error(
                "the pieces touch in a line or a point, so their union is no "
                "surface that can be cut");
        }
    }
    whole.collect_garbage();
    return whole;
}

UnionAnswer answerOf(const ExactMesh& mesh) {
    UnionAnswer answer;
    for (const auto v : mesh.vertices()) {
        const Kernel::Point_3& p = mesh.point(v);
        answer.positions.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                      CGAL::to_double(p.z()));
    }
    for (const auto face : mesh.faces()) {
        Triangle corners{};
        std::size_t i = 0;
        for (const auto v : mesh.vertices_around_face(mesh.halfedge(face))) {
            corners.at(i++) = static_cast<int>(v.idx());
        }
        answer.triangles.push_back(corners);
    }
    return answer;
}

UnionAnswer tryToUnite(const TriangleSoup& soup, const CrossingPieces& pieces,
                       const std::vector<int>& group) {
    try {
        return answerOf(united(soup, pieces, group));
    } catch (const pmp::Corefinement::Self_intersection_exception&) {
        return {.failure = "a piece passes through itself"};
    } catch (const std::bad_alloc&) {
        return {.failure = "it needs more memory than there is"};
    } catch (const std::exception& error) {
        return {.failure = error.what()};
    }
}

/// In a copy of this process, which ends when its time is over: the rest of the repair does not
/// depend on it.
UnionAnswer uniteWithinLimits(const TriangleSoup& soup, const CrossingPieces& pieces,
                              const std::vector<int>& group) {
    Pipe pipe;
    const pid_t copy = ::fork();
    if (copy == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        limitProcessorTime(kUnionSeconds);
        ByteWriter out;
        const UnionAnswer answer = tryToUnite(soup, pieces, group);
        out(answer);
        const std::string_view bytes(reinterpret_cast<const char*>(out.bytes.data()),
                                     out.bytes.size());
        ::_exit(writeAll(pipe.write.get(), bytes) ? 0 : 1);
    }
    pipe.write.close();
    const std::string bytes = readToEnd(pipe.read.get());
    int status = 0;
    if (copy < 0 || ::waitpid(copy, &status, 0) != copy) {
        return {.failure = "another process can't be started"};
    }
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
        return {.failure = "it takes more than two minutes"};
    }
    UnionAnswer answer;
    try {
        ByteReader in(std::as_bytes(std::span(bytes)));
        in(answer);
    } catch (const std::out_of_range&) {
        return {.failure = "the exact union failed"};
    }
    return answer;
}

/// A group of pieces as one surface.
struct United {
    std::vector<int> group;
    TriangleSoup surface;
};

/// A surface as a file of floats holds it, mended where it falls together; nothing where that
/// leaves none of its volume that can be cut.
std::optional<TriangleSoup> soundSurface(const UnionAnswer& exact) {
    constexpr double kMostLost = 1e-3;  // of the volume
    TriangleSoup surface;
    surface.positions = exact.positions;
    surface.triangles = exact.triangles;
    const double volume = inspectTriangles(surface).volume;
    roundToFloats(surface);
    if (!inspectTriangles(surface).cuttable) {
        repairSoup(surface);
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

PieceUnion uniteCrossingPieces(TriangleSoup& welded) {
    tellStage("Looking for pieces that cross");
    PieceUnion outcome;
    const CrossingPieces pieces(welded);
    if (const int count = pieces.crossingThemselves(); count > 0) {
        outcome.left.push_back(
            counted(count, "piece passes through itself", "pieces pass through themselves") +
            ", which no repair here mends; mend it in a modelling tool");
    }
    std::vector<United> all;
    for (const std::vector<int>& group : pieces.groups()) {
        tellStage("Uniting pieces that cross");
        const UnionAnswer answer = uniteWithinLimits(welded, pieces, group);
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

}  // namespace kerf::app
