#include "sim/cut/cleanup/flip.h"

#include "sim/cut/cleanup/acceptance.h"
#include "sim/cut/cleanup/copies.h"
#include "sim/cut/cleanup/self_piercing.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

// Cosine of the largest turn of the new triangles from the old ones.
constexpr double kLargestTurn = 0.5;
// Twice the areas (shares of h^2) below which the old pair has no direction, or a new one none.
constexpr double kNoPair = 1e-6;
constexpr double kNoArea = 1e-9;
constexpr int kLeastFlippedValence = 4;
// Of triangles that are flipped so that the surface does not pass through itself.
constexpr double kLeastScore = 0.3;

/// An edge a -> b with the apexes c on its left and d on its right; flipped it is c -> d.
struct Quad {
    int halfEdge;
    int a, b, c, d;
};

/// The same quad at its places.
struct QuadShape {
    Vec3 a, b, c, d;

    /// That a flip adds, up to its sign; those of the two walls of a slit have opposite signs.
    double volume() const { return tetrahedronVolume(b - a, c - a, d - a); }
    /// Distance between the lines of the two diagonals.
    double height() const {
        const Vec3 across = (b - a).cross(d - c);
        return across.norm() > 0 ? std::fabs((c - a).dot(across)) / across.norm() : 0;
    }
};

// t = abc and o = bad become t = cad and o = dbc.
void flip(SurfaceMesh& mesh, const Quad& q) {
    const int h = q.halfEdge;
    const int g = mesh.twin(h);
    const int t = h / 3, o = g / 3;
    const int outerBc = mesh.twin(SurfaceMesh::next(h));
    const int outerCa = mesh.twin(SurfaceMesh::previous(h));
    const int outerAd = mesh.twin(SurfaceMesh::next(g));
    const int outerDb = mesh.twin(SurfaceMesh::previous(g));
    mesh.setCorners(t, {q.c, q.a, q.d});
    mesh.setCorners(o, {q.d, q.b, q.c});
    mesh.link(3 * t, outerCa);
    mesh.link(3 * t + 1, outerAd);
    mesh.link(3 * t + 2, 3 * o + 2);
    mesh.link(3 * o, outerDb);
    mesh.link(3 * o + 1, outerBc);
    mesh.setOutgoing(q.c, 3 * t);
    mesh.setOutgoing(q.a, 3 * t + 1);
    mesh.setOutgoing(q.d, 3 * o);
    mesh.setOutgoing(q.b, 3 * o + 1);
}

enum class FlipGoal { betterTriangles, fewerPiercings };

class Flip {
  public:
    Flip(Workspace& workspace, int h, FlipGoal goal)
        : workspace_(workspace),
          goal_(goal),
          mesh_(workspace.mesh),
          h_(h),
          from_(starOf(mesh_, mesh_.origin(h))) {}

    bool run() {
        if (!isFlippable() || !findCopies() || !keepsComplex()) {
            return false;
        }
        Scores before;
        Scores after;
        for (const Quad& quad : quads_) {
            if (!isConvex(quad)) {
                return false;
            }
            addScores(quad, before, after);
            measure(quad);
        }
        if (!isWorth(before, after) || !staysNear() || !workspace_.allows(defect_, onWalls_) ||
            !keepsApart()) {
            return false;
        }
        carryOut();
        return true;
    }

  private:
    // Smooth where slits are closed, with two different points opposite to it.
    bool isFlippable() {
        const SharedEdge* edge = from_.edgeTo(mesh_.firstCopy(mesh_.target(h_)));
        if (edge == nullptr || edge->isFeature() || edge->faces[0].apex == edge->faces[1].apex) {
            return false;
        }
        onWalls_ = edge->type() == SharedEdgeType::wall;
        return true;
    }

    // One copy in the skin, two in walls.
    bool findCopies() {
        const int to = mesh_.firstCopy(mesh_.target(h_));
        for (const int v : from_.copies) {
            mesh_.forEachOutgoing(v, [&](int h) {
                if (mesh_.firstCopy(mesh_.target(h)) == to) {
                    quads_.push_back(
                        {h, v, mesh_.target(h), mesh_.apex(h), mesh_.apex(mesh_.twin(h))});
                }
            });
        }
        return quads_.size() == (onWalls_ ? 2 : 1) && isInOneSheet() && isBehindFront() &&
               !isUntouched();
    }

    bool isUntouched() const {
        const Quad& q = quads_.front();
        return std::ranges::all_of(std::array{q.a, q.b, q.c, q.d},
                                   [&](int v) { return workspace_.isKept({v}); });
    }

    bool isBehindFront() const {
        return std::none_of(quads_.begin(), quads_.end(), [&](const Quad& q) {
            return workspace_.trianglesTouchRung({q.halfEdge / 3, mesh_.twin(q.halfEdge) / 3});
        });
    }

    bool isInOneSheet() const {
        return std::all_of(quads_.begin(), quads_.end(), [&](const Quad& q) {
            return mesh_.wallLabel(q.halfEdge / 3) == mesh_.wallLabel(mesh_.twin(q.halfEdge) / 3);
        });
    }

    bool keepsComplex() const {
        const Quad& first = quads_.front();
        if (starOf(mesh_, first.c).edgeTo(mesh_.firstCopy(first.d)) != nullptr) {
            return false;
        }
        const Quad& last = quads_.back();
        const bool sameEnds = std::minmax(first.c, first.d) == std::minmax(last.c, last.d);
        if (quads_.size() > 1 && sameEnds) {
            return false;
        }
        return std::all_of(quads_.begin(), quads_.end(), [&](const Quad& q) {
            return q.c != q.d && valence(mesh_, q.a) >= kLeastFlippedValence &&
                   valence(mesh_, q.b) >= kLeastFlippedValence;
        });
    }

    QuadShape shapeOf(const Quad& q) const {
        return {mesh_.position(q.a), mesh_.position(q.b), mesh_.position(q.c), mesh_.position(q.d)};
    }

    QuadShape restShapeOf(const Quad& q) const {
        return {mesh_.restPosition(q.a), mesh_.restPosition(q.b), mesh_.restPosition(q.c),
                mesh_.restPosition(q.d)};
    }

    bool isConvex(const Quad& quad) const {
        const QuadShape q = shapeOf(quad);
        const Vec3 first = areaNormal(q.c, q.a, q.d);
        const Vec3 second = areaNormal(q.d, q.b, q.c);
        const Vec3 old = areaNormal(q.a, q.b, q.c) + areaNormal(q.b, q.a, q.d);
        const double square = workspace_.edgeLength() * workspace_.edgeLength();
        const auto looksAsBefore = [&](const Vec3& n) {
            return n.norm() >= kNoArea * square &&
                   n.dot(old) >= kLargestTurn * n.norm() * old.norm();
        };
        return old.norm() >= kNoPair * square && looksAsBefore(first) && looksAsBefore(second);
    }

    void addScores(const Quad& quad, Scores& before, Scores& after) const {
        const double goodEdge = workspace_.goodEdgeLength();
        const QuadShape q = shapeOf(quad);
        before.add(triangleScore(mesh_, quad.halfEdge / 3, goodEdge));
        before.add(triangleScore(mesh_, mesh_.twin(quad.halfEdge) / 3, goodEdge));
        after.add(triangleScore({q.c, q.a, q.d}, goodEdge));
        after.add(triangleScore({q.d, q.b, q.c}, goodEdge));
    }

    void measure(const Quad& quad) {
        const QuadShape current = shapeOf(quad);
        const double rest = restShapeOf(quad).volume();
        net_.current += current.volume();
        net_.rest += rest;
        if (goal_ == FlipGoal::fewerPiercings) {
            defect_ = {std::fabs(net_.current), std::fabs(net_.rest)};
        } else {
            defect_.current =
                std::max({defect_.current, std::fabs(current.volume()), std::fabs(net_.current)});
            defect_.rest = std::max({defect_.rest, std::fabs(rest), std::fabs(net_.rest)});
        }
        if (!onWalls_) {
            deviation_ = std::max(deviation_, current.height());
        }
    }

    bool staysNear() {
        const Quad& q = quads_.front();
        deviation_ += workspace_.deviationAt({q.a, q.b, q.c, q.d});
        return deviation_ <= workspace_.mostDeviation();
    }

    bool isWorth(const Scores& before, const Scores& after) const {
        return goal_ == FlipGoal::betterTriangles
                   ? improves(before, after)
                   : after.worst >= std::min(kLeastScore, before.worst);
    }

    bool keepsApart() const {
        return goal_ == FlipGoal::betterTriangles ? !addsPiercings(mesh_, flipped())
                                                  : removesPiercings(mesh_, flipped());
    }

    std::vector<std::pair<int, Triangle>> flipped() const {
        std::vector<std::pair<int, Triangle>> triangles;
        for (const Quad& q : quads_) {
            triangles.push_back({q.halfEdge / 3, {q.c, q.a, q.d}});
            triangles.push_back({mesh_.twin(q.halfEdge) / 3, {q.d, q.b, q.c}});
        }
        return triangles;
    }

    void carryOut() {
        for (const Quad& quad : quads_) {
            const int other = mesh_.twin(quad.halfEdge) / 3;
            flip(workspace_.mesh, quad);
            workspace_.noteChanged(quad.halfEdge / 3);
            workspace_.noteChanged(other);
            for (const int v : {quad.c, quad.d}) {
                workspace_.setDeviation({v}, std::max(deviation_, workspace_.deviationAt({v})));
            }
        }
        workspace_.spend(defect_);
    }

    Workspace& workspace_;
    FlipGoal goal_;
    const SurfaceMesh& mesh_;
    int h_;
    SharedStar from_;
    bool onWalls_ = false;
    std::vector<Quad> quads_;
    VolumeDefect net_;  ///< signed; walls that noise has moved apart don't cancel
    /// Of the worst copy, or of all together. Where the two walls of a slit pass through the skin
    /// beside them one side may give the other what the body keeps.
    VolumeDefect defect_;
    double deviation_ = 0;
};

}  // namespace

bool flipEdge(Workspace& workspace, int h) {
    return Flip(workspace, h, FlipGoal::betterTriangles).run();
}

bool flipEdgeApart(Workspace& workspace, int h) {
    return Flip(workspace, h, FlipGoal::fewerPiercings).run();
}

}  // namespace kerf::cut
