#pragma once

#include "sim/mesh/triangle.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// Makes the triangles of a soup even where allowed: long edges are divided, short ones collapse,
/// edges are flipped towards six triangles a vertex, and vertices move to the middle of their
/// neighbours, along the surface (Botsch and Kobbelt 2004). Closed and manifold surfaces stay so.
class Remesher {
  public:
    /// Its task.
    struct Order {
        std::vector<double> edge;  ///< target length, by triangle [m]
        /// By triangle: whether it may change; those that may not keep their corners. Empty: all.
        std::vector<char> free;
        /// Projects a moved point onto the surface; empty: none.
        std::function<Vec3(const Vec3&)> project;
        double hardAngle = 40;  ///< edges bent more are preserved [degrees]; above 180 none
        int rounds = 10;
        /// Called before each round, counted from 0; may throw to end the work. May be null.
        std::function<void(int round)> onRound = nullptr;
    };

    /// The soup must be manifold and oriented where it is free.
    Remesher(TriangleSoup& soup, const Order& order);

    void run();

  private:
    void divideLong();
    void collapseShort();
    bool mayCollapse(int gone, int stays) const;
    void flipEdges();
    void relax();

    bool isFixed(int v) const { return fixed_[v] != 0; }
    std::vector<int> trianglesAt(int a, int b) const;
    bool isHard(const std::vector<int>& both) const;
    std::vector<int> hardEndsAt(int v) const;
    std::vector<int> neighboursOf(int v) const;
    double length(int a, int b) const;
    Corners cornersOf(const Triangle& t) const;
    Vec3 normalOf(const Triangle& t) const;
    void divide(int a, int b, const std::vector<int>& both);
    void collapse(int gone, int stays);
    bool staysGood(int v, int except, const Vec3& at) const;
    void flip(int a, int b, const std::vector<int>& both);
    bool improves(int a, int b, int c, int d) const;
    double leastQuality(const Triangle& first, const Triangle& second) const;
    bool keepsFacing(const std::vector<int>& both, const Triangle& first,
                     const Triangle& second) const;
    std::optional<Vec3> middleOf(int v) const;
    void moveTo(int v, const Vec3& at);
    int addTriangle(const Triangle& corners, int like);
    void removeTriangle(int t);
    void setTriangle(int t, const Triangle& corners);
    std::vector<std::pair<int, int>> freeEdges() const;
    void pack();

    TriangleSoup& soup_;
    const Order& order_;
    double cosHard_;
    std::vector<char> free_;            ///< by triangle
    std::vector<double> wanted_;        ///< target edge length, by triangle [m]
    std::vector<char> fixed_;           ///< by vertex: touches what is not free
    std::vector<std::vector<int>> at_;  ///< the living triangles of each vertex
};

/// Remeshes a closed, manifold, oriented soup to edges of about `edge` [m], on its own surface.
/// Preserves lines along which it is bent by more than 40 degrees. `onRound`: see Remesher::Order.
void remesh(TriangleSoup& soup, double edge,
            const std::function<void(int round)>& onRound = nullptr);

}  // namespace kerf::app
