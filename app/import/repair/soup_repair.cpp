#include "app/import/repair/soup_repair.h"

#include "app/import/repair/double_triangles.h"
#include "app/import/repair/edge_pairing.h"
#include "app/import/repair/near_borders.h"
#include "app/import/repair/surface_meshing.h"
#include "sim/base/text.h"
#include "sim/mesh/triangle.h"
#include "sim/repair/shell_nesting.h"
#include "sim/repair/soup_editing.h"
#include "sim/repair/soup_inspection.h"

namespace kerf::app {

namespace {

using repair::Side;

constexpr int kMostRounds = 4;
// A sheet that can't be closed is dropped where it is no larger than this share of the whole.
constexpr double kLooseShare = 0.05;

/// The steps of a repair, and what they did.
class Repair {
  public:
    Repair(TriangleSoup& soup, bool fills) : soup_(soup), fills_(fills) {}

    std::vector<std::string> run() {
        dropUnusable();
        for (int round = 0; round < kMostRounds && !inspectTriangles(soup_).cuttable; ++round) {
            joinBorders();
            dissolveFlatTriangles();
            dropDoubles();
            orient();
            if (fills_ || inspectTriangles(soup_).misorientedEdges == 0) {
                part();
            }
            if (fills_) {
                dropLooseSheets();
                fill();
            }
            if (!dropFlatParts()) {
                break;
            }
            turn();
        }
        repair::dropUnusedVertices(soup_);
        return describe();
    }

  private:
    void note(const char* one, const char* many, int count) {
        if (count > 0) {
            const auto found = std::ranges::find(done_, many, &Deed::many);
            if (found == done_.end()) {
                done_.push_back({one, many, count});
            } else {
                found->count += count;
            }
        }
    }

    std::vector<std::string> describe() const {
        std::vector<std::string> phrases;
        for (const Deed& deed : done_) {
            std::string phrase = deed.count == 1 ? deed.one : deed.many;
            const auto place = phrase.find('#');
            phrases.push_back(phrase.replace(place, 1, std::to_string(deed.count)));
        }
        return phrases;
    }

    void dropUnusable() {
        const int dropped = repair::keepTriangles(soup_, [this](int t) {
            return repair::isUsable(soup_, soup_.triangles[t]) &&
                   !repair::repeatsCorner(soup_.triangles[t]);
        });
        note("dropped # triangle with a repeated or missing corner",
             "dropped # triangles with a repeated or missing corner", dropped);
        for (Vec3& p : soup_.positions) {
            p = p.allFinite() ? p : Vec3(Vec3::Zero());
        }
        soup_ = dropped > 0 ? weldObjects(soup_) : soup_;
    }

    bool isFlat(int t) const { return areaNormal(repair::cornersOf(soup_, t)).isZero(0); }

    /// Three corners in one line: the neighbour across the longest edge is divided in its stead.
    void dissolveFlatTriangles() {
        int dissolved = 0;
        const auto count = static_cast<int>(soup_.triangles.size());
        std::vector<char> keep(soup_.triangles.size(), 1);
        std::vector<Side> sides;
        for (int t = 0; t < count; ++t) {
            if (!isFlat(t)) {
                continue;
            }
            sides = sides.empty() ? repair::sidesByEdge(soup_.triangles) : std::move(sides);
            keep[t] = dissolve(t, sides) ? 1 : 0;
            ++dissolved;
        }
        repair::keepTriangles(soup_, [&](int t) { return keep[t] != 0; });
        note("dissolved # triangle without area", "dissolved # triangles without area", dissolved);
    }

    int longestSide(int t) const {
        const Corners at = repair::cornersOf(soup_, t);
        int longest = 0;
        for (int i = 1; i < 3; ++i) {
            const auto length = [&](int k) { return (at[(k + 1) % 3] - at[k]).squaredNorm(); };
            longest = length(i) > length(longest) ? i : longest;
        }
        return longest;
    }

    /// Whether its slot is used for half of the neighbour; else it goes.
    bool dissolve(int t, const std::vector<Side>& sides) {
        const int side = longestSide(t);
        const int a = soup_.triangles[t][side];
        const int b = soup_.triangles[t][(side + 1) % 3];
        const int middle = soup_.triangles[t][(side + 2) % 3];
        const int other = onlyNeighbour(t, a, b, sides);
        if (other < 0 ||
            std::ranges::find(soup_.triangles[other], middle) != soup_.triangles[other].end()) {
            return false;
        }
        // Both halves are the neighbour with one end of the edge moved to the middle.
        const TriangleAttributes attributes = attributesOf(soup_.skin, other);
        Triangle half = soup_.triangles[other];
        std::ranges::replace(soup_.triangles[other], a, middle);
        std::ranges::replace(half, b, middle);
        soup_.triangles[t] = half;
        setAttributes(soup_.skin, t, attributes);
        return true;
    }

    /// The one other triangle at an edge, -1 where there is none or several. The sides are those of
    /// before: what has been divided since is none.
    int onlyNeighbour(int t, int a, int b, const std::vector<Side>& sides) const {
        const std::pair edge(std::min(a, b), std::max(a, b));
        const auto edgeOf = [](const Side& s) { return std::pair(s.low, s.high); };
        const auto first = std::ranges::lower_bound(sides, edge, {}, edgeOf);
        const auto end = std::ranges::upper_bound(sides, edge, {}, edgeOf);
        if (end - first != 2) {
            return -1;
        }
        const int other = first->triangle() == t ? first[1].triangle() : first->triangle();
        const Triangle& corners = soup_.triangles[other];
        const bool still = std::ranges::find(corners, a) != corners.end() &&
                           std::ranges::find(corners, b) != corners.end();
        return still && other != t && !isFlat(other) ? other : -1;
    }

    void dropDoubles() {
        note("dropped # double of a triangle", "dropped # doubles of triangles",
             app::dropDoubles(soup_));
    }

    void joinBorders() {
        const JoinedBorders joined = joinNearBorders(soup_);
        note("joined # vertex that nearly met another", "joined # vertices that nearly met others",
             joined.vertices);
        note("divided # open edge where a vertex lay on it",
             "divided # open edges where vertices lay on them", joined.edges);
    }

    void orient() {
        note("turned # triangle to face as those beside it",
             "turned # triangles to face as those beside them", orientAlike(soup_));
    }

    void part() {
        const PartedSurface parted = partBranches(soup_);
        note("parted the surface at # edge of more than two triangles",
             "parted the surface at # edges of more than two triangles", parted.edges);
        note("parted the surface at # vertex where it touched itself",
             "parted the surface at # vertices where it touched itself", parted.vertices);
    }

    /// Sheets with a border that holes can't be filled of, as single triangles.
    void dropLooseSheets() {
        constexpr int kLeastThatCloses = 3;
        const std::vector<int> parts = repair::partsOf(soup_);
        const std::vector<double> areas = repair::areasOf(soup_, parts);
        const std::vector<char> open = openParts(parts, areas.size());
        std::vector<int> counts(areas.size(), 0);
        for (const int part : parts) {
            ++counts[part];
        }
        const double all = std::accumulate(areas.begin(), areas.end(), 0.0);
        std::vector<char> loose(areas.size(), 0);
        for (std::size_t p = 0; p < areas.size(); ++p) {
            loose[p] = open[p] != 0 && areas[p] < kLooseShare * all && counts[p] < kLeastThatCloses;
        }
        dropParts(parts, loose, "dropped # loose sheet", "dropped # loose sheets");
    }

    std::vector<char> openParts(const std::vector<int>& parts, std::size_t count) const {
        std::vector<char> open(count, 0);
        for (const Side& side : repair::openSides(soup_)) {
            open[parts[side.triangle()]] = 1;
        }
        return open;
    }

    void fill() { note("filled # hole", "filled # holes", fillHoles(soup_, true).holes); }

    /// Sheets that filling has only doubled. False where there is nothing else, so that no repair
    /// will help.
    bool dropFlatParts() {
        const repair::SoupShells shells = repair::measureShells(soup_);
        std::vector<char> flat = openParts(shells.ofTriangle, shells.volumes.size());
        for (int shell = 0; shell < shells.size(); ++shell) {
            flat[shell] = flat[shell] == 0 && shells.isFlat(shell);
        }
        const bool anyLeft = std::ranges::find(flat, 0) != flat.end();
        if (anyLeft) {
            dropParts(shells.ofTriangle, flat, "dropped # sheet that encloses no volume",
                      "dropped # sheets that enclose no volume");
        }
        return anyLeft;
    }

    void dropParts(const std::vector<int>& parts, const std::vector<char>& which, const char* one,
                   const char* many) {
        repair::keepTriangles(soup_, [&](int t) { return which[parts[t]] == 0; });
        note(one, many,
             static_cast<int>(std::ranges::count_if(which, [](char w) { return w != 0; })));
    }

    void turn() {
        const MeshReport found = inspectTriangles(soup_);
        if (found.insideOutPieces + found.outwardCavities > 0) {
            turnOutward(soup_);
            note("turned # piece that was inside out", "turned # pieces that were inside out",
                 found.insideOutPieces);
            note("turned # shell inside another one inwards, around a cavity",
                 "turned # shells inside another one inwards, around cavities",
                 found.outwardCavities);
        }
    }

    /// What was done so often; '#' stands for the number.
    struct Deed {
        std::string one;
        std::string many;
        int count;
    };

    TriangleSoup& soup_;
    bool fills_;
    std::vector<Deed> done_;
};

}  // namespace

std::vector<std::string> repairSoup(TriangleSoup& welded, bool fillsHoles) {
    return Repair(welded, fillsHoles).run();
}

}  // namespace kerf::app
