#include "sim/cut/plan/inner_points.h"

#include <algorithm>
#include <cmath>

namespace kerf::cut {

namespace {

// Shares of the edge length there.
constexpr double kTallSheet = 1.2;
constexpr double kSteinerToNode = 0.6;
constexpr double kSteinerToEdge = 0.4;
constexpr int kMostSteinerPoints = 200000;
constexpr double kLattices = 2;  // for each doubling of the edge length

class InnerPoints {
  public:
    InnerPoints(const StepInput& in, const RestGuess& guess, const PlacesInStrip& places,
                const std::vector<CutNode>& nodes, BorderedSheet& sheet)
        : in_(in),
          guess_(guess),
          places_(places),
          nodes_(nodes),
          sheet_(sheet),
          plane_(sheet.plane()) {}

    // Only single big steps make sheets tall enough to need points inside: hexagonal lattices, the
    // coarse ones first, each where its spacing is the edge length.
    void run() {
        const auto [most, least] = edgeLengthsAtBorder();
        if (sheet_.bounds().high.y() - sheet_.bounds().low.y() <= kTallSheet * least) {
            return;
        }
        const int levels = static_cast<int>(std::lround(kLattices * std::log2(most / least)));
        const double widest = levels == 0 && most > least ? std::sqrt(most * least) : most;
        for (int level = 0; level <= levels; ++level) {
            insertLattice(widest * std::exp2(-level / kLattices),
                          {level == 0 ? 1e300 : std::exp2(0.5 / kLattices),
                           level == levels ? 0 : std::exp2(-0.5 / kLattices)});
        }
    }

  private:
    struct Range {
        double most;
        double least;
    };

    Range edgeLengthsAtBorder() const {
        Range range{0, 1e300};
        for (const OutlineEdge& edge : sheet_.border()) {
            const CutNode& node = nodes_[edge.from];
            const double length = in_.edgeLengths.localEdgeLength(
                node.kind == NodeKind::wall ? guess_.at(node.position) : node.rest);
            range = {std::max(range.most, length), std::min(range.least, length)};
        }
        return range;
    }

    /// `share`: of the spacing that the edge length of a point may be.
    void insertLattice(double spacing, const Range& share) {
        const Vec2 extent = sheet_.bounds().high - sheet_.bounds().low;
        const double rowHeight = 0.866 * spacing;
        const double rows = std::floor(extent.y() / rowHeight);
        const double columns = std::floor(extent.x() / spacing);
        if (rows * columns > kMostSteinerPoints) {
            return;
        }
        plane_.reserve(static_cast<std::size_t>((rows + 1) * (columns + 1)));
        for (int j = 0; j <= static_cast<int>(rows); ++j) {
            for (int i = 0; i <= static_cast<int>(columns); ++i) {
                const double shift = j % 2 == 1 ? 0.5 : 0.0;
                tryInsertSteiner({sheet_.bounds().low.x() + (i + shift) * spacing,
                                  sheet_.bounds().low.y() + (j + 0.5) * rowHeight},
                                 spacing, share);
            }
        }
    }

    void tryInsertSteiner(const Vec2& p, double spacing, const Range& share) {
        const Triangulation::Location at = plane_.locate(p);
        if (at.where != Triangulation::Where::inside || !plane_.marked(at.triangle) ||
            tooClose(at.triangle, p, spacing)) {
            return;
        }
        const Vec3 position = places_.at(p);
        const double edge = in_.edgeLengths.localEdgeLength(guess_.at(position));
        if (edge < share.most * spacing && edge >= share.least * spacing) {
            sheet_.addInner(p, position, at);
        }
    }

    bool tooClose(int t, const Vec2& p, double spacing) const {
        for (int i = 0; i < 3; ++i) {
            const Vec2& a = plane_.point(plane_.corners(t)[i]);
            const Vec2& b = plane_.point(plane_.corners(t)[(i + 1) % 3]);
            if ((a - p).norm() < kSteinerToNode * spacing) {
                return true;
            }
            const double distance = std::fabs(cross2(b - a, p - a)) / (b - a).norm();
            if (plane_.constrained(t, i) && distance < kSteinerToEdge * spacing) {
                return true;
            }
        }
        return false;
    }

    const StepInput& in_;
    const RestGuess& guess_;
    const PlacesInStrip& places_;
    const std::vector<CutNode>& nodes_;
    BorderedSheet& sheet_;
    Triangulation& plane_;
};

}  // namespace

void addInnerPoints(const StepInput& in, const RestGuess& guess, const PlacesInStrip& places,
                    const std::vector<CutNode>& nodes, BorderedSheet& sheet) {
    InnerPoints(in, guess, places, nodes, sheet).run();
}

}  // namespace kerf::cut
