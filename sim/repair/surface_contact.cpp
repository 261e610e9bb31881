#include "sim/repair/surface_contact.h"

#include "sim/base/predicates.h"
#include "sim/mesh/triangle.h"

namespace kerf::repair {

namespace {

using Signs = std::array<int, 3>;

/// On which sides of a triangle's plane the corners of another one lie.
Signs signsOf(const Corners& corners, const Corners& plane) {
    Signs signs;
    std::ranges::transform(corners, signs.begin(), [&](const Vec3& p) {
        return orientSign3d(plane[0], plane[1], plane[2], p);
    });
    return signs;
}

bool onOneSide(const Signs& signs) {
    return signs[0] != 0 && signs[0] == signs[1] && signs[0] == signs[2];
}

bool onBothSides(const Signs& signs) {
    return std::ranges::find(signs, 1) != signs.end() &&
           std::ranges::find(signs, -1) != signs.end();
}

/// The corner that lies on its side of the plane alone.
int aloneAt(const Signs& signs) {
    const int sign = std::ranges::count(signs, 1) == 1 ? 1 : -1;
    return static_cast<int>(std::ranges::find(signs, sign) - signs.begin());
}

Corners beginningAt(int corner, const Corners& c) {
    return {c[corner], c[(corner + 1) % 3], c[(corner + 2) % 3]};
}

/// The line of a half-edge.
Line lineOf(const TriangleSoup& soup, int h) {
    return {soup.positions[originOf(soup, h)], soup.positions[soup.triangles[h / 3][(h + 1) % 3]]};
}

/// The material at a half-edge with a partner, about the half-edge's own line.
Wedge wedgeOf(const TriangleSoup& soup, const Partners& partners, int h) {
    return {soup.positions[apexOf(soup, partners[h])], soup.positions[apexOf(soup, h)]};
}

/// Points of one plane without a coordinate that they do not need.
struct PlaneView {
    int axis;

    int orient(const Vec3& a, const Vec3& b, const Vec3& c) const {
        return orient2d(without(axis, a), without(axis, b), without(axis, c));
    }
};

/// Whether a piece of a line in the plane of a triangle has more than a point of its inside.
bool liesInside(const Line& line, const Corners& triangle, PlaneView view) {
    const auto& [a, b, c] = triangle;
    const int facing = view.orient(a, b, c);
    const auto isBeyond = [&](const Vec3& from, const Vec3& to) {
        return view.orient(from, to, line.u) * facing <= 0 &&
               view.orient(from, to, line.v) * facing <= 0;
    };
    return onBothSides({view.orient(line.u, line.v, a), view.orient(line.u, line.v, b),
                        view.orient(line.u, line.v, c)}) &&
           !isBeyond(a, b) && !isBeyond(b, c) && !isBeyond(c, a);
}

/// The material behind a triangle, about a line that lies in it.
Wedge wedgeOf(const Line& line, const Corners& triangle, PlaneView view) {
    const int facing = view.orient(triangle[0], triangle[1], triangle[2]);
    const auto corner = [&](int side) {
        return *std::ranges::find_if(triangle, [&](const Vec3& p) {
            return view.orient(line.u, line.v, p) * facing == side;
        });
    };
    return {.from = corner(-1), .to = corner(1)};
}

/// Whether two pieces of one line have more than a point in common.
bool overlap(const Line& a, const Line& b) {
    const auto apart = [](double first, double second, double low, double high) {
        return std::max(first, second) <= std::min(low, high);
    };
    for (int i = 0; i < 3; ++i) {
        if (a.u[i] != a.v[i]) {
            return !apart(a.u[i], a.v[i], b.u[i], b.v[i]) && !apart(b.u[i], b.v[i], a.u[i], a.v[i]);
        }
    }
    return false;
}

/// Whether two pieces of one line run the same way.
bool runAlike(const Line& a, const Line& b) {
    for (int i = 0; i < 3; ++i) {
        if (a.u[i] != a.v[i]) {
            return (a.u[i] < a.v[i]) == (b.u[i] < b.v[i]);
        }
    }
    return true;
}

/// Whether the insides of two triangles, each with corners on both sides of the other's plane, meet
/// in more than a point: by the order of the four places where their sides meet the line of both
/// planes (Guigue and Devillers 2003).
bool insidesMeet(const Corners& a, const Signs& ofA, const Corners& b, const Signs& ofB) {
    const int firstOfA = aloneAt(ofA);
    const int firstOfB = aloneAt(ofB);
    auto [p1, q1, r1] = beginningAt(firstOfA, a);
    auto [p2, q2, r2] = beginningAt(firstOfB, b);
    // The corner alone on its side is then on that which the other triangle faces.
    if (ofB[firstOfB] < 0) {
        std::swap(q1, r1);
    }
    if (ofA[firstOfA] < 0) {
        std::swap(q2, r2);
    }
    return orientSign3d(p1, q1, p2, q2) < 0 && orientSign3d(p1, r1, r2, p2) < 0;
}

/// The length over which two triangles cover the same part of an axis [m]; infinite without one.
double overlapAlong(const Vec3& axis, const Corners& a, const Corners& b) {
    std::array<double, 3> ofA{};
    std::array<double, 3> ofB{};
    for (int i = 0; i < 3; ++i) {
        ofA[i] = (a[i] - a[0]).dot(axis);
        ofB[i] = (b[i] - a[0]).dot(axis);
    }
    const auto [lowA, highA] = std::ranges::minmax(ofA);
    const auto [lowB, highB] = std::ranges::minmax(ofB);
    const double length = axis.norm();
    return length > 0 ? std::min(highA - lowB, highB - lowA) / length
                      : std::numeric_limits<double>::infinity();
}

/// The part of a polygon on the positive side of a plane.
std::vector<Vec3> clip(const std::vector<Vec3>& polygon, const Vec3& origin, const Vec3& normal) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& p = polygon[i];
        const Vec3& q = polygon[(i + 1) % polygon.size()];
        const double ofP = normal.dot(p - origin);
        const double ofQ = normal.dot(q - origin);
        if (ofP >= 0) {
            kept.push_back(p);
        }
        if ((ofP < 0) != (ofQ < 0)) {
            kept.push_back(p + (q - p) * (ofP / (ofP - ofQ)));
        }
    }
    return kept;
}

/// How far the part of a triangle that lies over or under another one reaches through its plane on
/// the side where it reaches less far [m].
double depthOver(const Corners& plane, const Corners& triangle) {
    const Vec3 normal = areaNormal(plane).stableNormalized();
    std::vector<Vec3> part(triangle.begin(), triangle.end());
    for (int i = 0; i < 3; ++i) {
        part = clip(part, plane[i], normal.cross(plane[(i + 1) % 3] - plane[i]));
    }
    double above = 0;
    double below = 0;
    for (const Vec3& p : part) {
        above = std::max(above, normal.dot(p - plane[0]));
        below = std::max(below, normal.dot(plane[0] - p));
    }
    return std::min(above, below);
}

}  // namespace

bool passThrough(const Corners& a, const Corners& b) {
    const Signs ofA = signsOf(a, b);
    const Signs ofB = onBothSides(ofA) ? signsOf(b, a) : Signs{};
    return onBothSides(ofB) && insidesMeet(a, ofA, b, ofB);
}

double crossingDepth(const Corners& a, const Corners& b) {
    double depth = std::min(depthOver(a, b), depthOver(b, a));
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            depth = std::min(
                depth, overlapAlong((a[(i + 1) % 3] - a[i]).cross(b[(j + 1) % 3] - b[j]), a, b));
        }
    }
    return std::max(0.0, depth);
}

SurfaceContact::SurfaceContact(const TriangleSoup& soup)
    : soup_(soup), partners_(partnersOf(sidesByEdge(soup.triangles), soup.triangles.size())) {}

bool SurfaceContact::hasTwoFaces(int h) const {
    return partners_[h] >= 0 && originOf(soup_, partners_[h]) != originOf(soup_, h);
}

bool SurfaceContact::crosses(int a, int b) const {
    const Corners cornersOfA = cornersOf(soup_, a);
    const Corners cornersOfB = cornersOf(soup_, b);
    const Signs ofA = signsOf(cornersOfA, cornersOfB);
    if (onOneSide(ofA)) {
        return false;
    }
    const Signs ofB = ofA == Signs{} ? ofA : signsOf(cornersOfB, cornersOfA);
    if (onBothSides(ofA) && onBothSides(ofB)) {
        return insidesMeet(cornersOfA, ofA, cornersOfB, ofB);
    }
    return edgesCross(a, edgesInPlane(a, ofA), b, edgesInPlane(b, ofB));
}

bool SurfaceContact::edgesCross(int a, const std::vector<int>& ofA, int b,
                                const std::vector<int>& ofB) const {
    const auto alongEdgeOfB = [&](int h) {
        return std::ranges::any_of(ofB, [&](int g) { return crossesAlong(h, g); });
    };
    return std::ranges::any_of(ofA,
                               [&](int h) { return crossesInside(h, b) || alongEdgeOfB(h); }) ||
           std::ranges::any_of(ofB, [&](int g) { return crossesInside(g, a); });
}

std::vector<int> SurfaceContact::edgesInPlane(int triangle, const std::array<int, 3>& signs) const {
    std::vector<int> edges;
    for (int i = 0; i < 3; ++i) {
        if (signs[i] == 0 && signs[(i + 1) % 3] == 0 && hasTwoFaces(3 * triangle + i)) {
            edges.push_back(3 * triangle + i);
        }
    }
    return edges;
}

bool SurfaceContact::crossesInside(int h, int triangle) const {
    const Line line = lineOf(soup_, h);
    const Corners corners = cornersOf(soup_, triangle);
    const PlaneView view{axisToLeaveOut(corners[0], corners[1], corners[2])};
    return view.axis >= 0 && liesInside(line, corners, view) &&
           wedgesCross(line, wedgeOf(soup_, partners_, h), wedgeOf(line, corners, view));
}

bool SurfaceContact::crossesAlong(int h, int g) const {
    const Line line = lineOf(soup_, h);
    const Line other = lineOf(soup_, g);
    if (!isOn(line, other.u) || !isOn(line, other.v) || !overlap(line, other)) {
        return false;
    }
    const int along = runAlike(line, other) ? g : partners_[g];
    return wedgesCross(line, wedgeOf(soup_, partners_, h), wedgeOf(soup_, partners_, along));
}

namespace {

/// How far a direction about a line is turned from another one, counter-clockwise.
enum class Turn { none, lessThanHalf, half, moreThanHalf };

/// Where a face lies in the directions about a line, as a wedge divides them.
enum class Sector { within, outside, onFrom, onTo };

/// Compares the half-planes that begin at a line, each known by a point of it.
class AroundLine {
  public:
    explicit AroundLine(const Line& line) : line_(line) {}

    Sector sectorOf(const Vec3& face, const Wedge& wedge) const {
        if (turn(wedge.from, face) == Turn::none) {
            return Sector::onFrom;
        }
        if (turn(wedge.to, face) == Turn::none) {
            return Sector::onTo;
        }
        return comesFirst(wedge.from, face, wedge.to) ? Sector::within : Sector::outside;
    }
    bool isFlat(const Wedge& wedge) const {
        return isOn(line_, wedge.from) || isOn(line_, wedge.to) ||
               turn(wedge.from, wedge.to) == Turn::none;
    }

  private:
    int side(const Vec3& a, const Vec3& b) const { return orientSign3d(line_.u, line_.v, a, b); }

    Turn turn(const Vec3& start, const Vec3& face) const {
        const int sign = side(start, face);
        if (sign != 0) {
            return sign > 0 ? Turn::lessThanHalf : Turn::moreThanHalf;
        }
        const int axis = axisToLeaveOut(line_.u, line_.v, start);
        const auto sideInPlane = [&](const Vec3& p) {
            return orient2d(without(axis, line_.u), without(axis, line_.v), without(axis, p));
        };
        return sideInPlane(start) == sideInPlane(face) ? Turn::none : Turn::half;
    }

    /// Whether a is met before b, counter-clockwise from the start.
    bool comesFirst(const Vec3& start, const Vec3& a, const Vec3& b) const {
        const Turn toA = turn(start, a);
        const Turn toB = turn(start, b);
        const bool oneHalf = toA == Turn::lessThanHalf || toA == Turn::moreThanHalf;
        return toA != toB ? toA < toB : oneHalf && side(a, b) > 0;
    }

    const Line& line_;
};

/// Whether the faces of b say so: one has its material where a has it too, or just one lies in a.
bool facesCross(const AroundLine& around, const Wedge& a, const Wedge& b) {
    const Sector from = around.sectorOf(b.from, a);
    const Sector to = around.sectorOf(b.to, a);
    if (from == Sector::onFrom || to == Sector::onTo) {
        return true;
    }
    return (from == Sector::within) != (to == Sector::within);
}

}  // namespace

bool isOn(const Line& line, const Vec3& p) {
    return axisToLeaveOut(line.u, line.v, p) < 0;
}

bool wedgesCross(const Line& line, const Wedge& a, const Wedge& b) {
    const AroundLine around(line);
    if (around.isFlat(a) || around.isFlat(b)) {
        return false;
    }
    return facesCross(around, a, b) || facesCross(around, b, a);
}

int axisToLeaveOut(const Vec3& a, const Vec3& b, const Vec3& c) {
    for (int axis = 0; axis < 3; ++axis) {
        if (orient2d(without(axis, a), without(axis, b), without(axis, c)) != 0) {
            return axis;
        }
    }
    return -1;
}

Vec2 without(int axis, const Vec3& p) {
    return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

}  // namespace kerf::repair
