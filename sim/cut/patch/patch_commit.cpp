#include "sim/cut/patch/patch_commit.h"

#include "sim/cut/cut_change.h"

namespace kerf::cut {

namespace {

enum class Side { plus, minus };

class PatchCommit {
  public:
    PatchCommit(SurfaceMesh& mesh, const Wound& wound, const PatchPlan& plan)
        : mesh_(mesh),
          wound_(wound),
          plan_(plan),
          plus_(sideOf(Side::plus)),
          minus_(sideOf(Side::minus)) {}

    std::vector<int> run(CutDelta& delta) {
        removeWalls(delta);
        addVertices();
        std::vector<int> changed = removed_;
        for (const OneSide* side : {&plus_, &minus_}) {
            const int first = mesh_.triangleSlots();
            addTriangles(*side);
            for (int t = first; t < mesh_.triangleSlots(); ++t) {
                delta.addedTriangles.push_back(t);
                changed.push_back(t);
            }
        }
        return changed;
    }

  private:
    struct OneSide {
        Side side;
        int label;
        std::vector<int> vertices;    ///< of the nodes
        std::vector<int> neighbours;  ///< by rim edge: the half-edge of the surface along it
    };

    OneSide sideOf(Side side) const {
        const bool isPlus = side == Side::plus;
        OneSide result{
            side, mesh_.wallLabel((isPlus ? wound_.plus : wound_.minus).front()), {}, {}};
        for (const WoundEdge& edge : plan_.rim) {
            result.vertices.push_back(isPlus ? mesh_.origin(edge.plus) : mesh_.target(edge.minus));
            result.neighbours.push_back(mesh_.twin(isPlus ? edge.plus : edge.minus));
        }
        return result;
    }

    void removeWalls(CutDelta& delta) {
        std::set<int> vertices;
        std::ranges::merge(wound_.plus, sorted(wound_.minus), std::back_inserter(removed_));
        for (const int t : removed_) {
            vertices.insert(mesh_.triangle(t).begin(), mesh_.triangle(t).end());
            mesh_.removeTriangle(t);
        }
        for (const OneSide* side : {&plus_, &minus_}) {
            for (const int v : side->vertices) {
                vertices.erase(v);
            }
        }
        const std::vector<int> dead(vertices.begin(), vertices.end());
        for (const int v : dead) {
            mesh_.removeVertex(v);
        }
        noteRemoved(removed_, dead, delta);
    }

    static std::vector<int> sorted(std::vector<int> values) {
        std::sort(values.begin(), values.end());
        return values;
    }

    void addVertices() {
        for (const std::vector<int>& nodes : plan_.inner) {
            for (OneSide* side : {&plus_, &minus_}) {
                side->vertices.push_back(addMean(nodes, side->vertices));
            }
            mesh_.joinCopies(plus_.vertices.back(), minus_.vertices.back());
        }
    }

    int addMean(const std::vector<int>& nodes, const std::vector<int>& vertices) {
        Vec3 position = Vec3::Zero();
        Vec3 rest = Vec3::Zero();
        Vec3 velocity = Vec3::Zero();
        for (const int i : nodes) {
            position += mesh_.position(vertices[i]);
            rest += mesh_.restPosition(vertices[i]);
            velocity += mesh_.velocity(vertices[i]);
        }
        const double count = sizeOf(nodes);
        return mesh_.addVertex(position / count, rest / count, velocity / count);
    }

    void addTriangles(const OneSide& side) {
        std::map<std::pair<int, int>, int> halfEdges;  // by nodes
        for (Triangle corners : plan_.triangles) {
            if (side.side == Side::minus) {
                std::swap(corners[1], corners[2]);
            }
            const auto& v = side.vertices;
            const int t = mesh_.addTriangle({v[corners[0]], v[corners[1]], v[corners[2]]},
                                            SurfaceKind::wall, side.label);
            for (int e = 0; e < 3; ++e) {
                halfEdges[{corners[e], corners[(e + 1) % 3]}] = 3 * t + e;
                mesh_.setOutgoing(v[corners[e]], 3 * t + e);
            }
        }
        for (const auto& [nodes, h] : halfEdges) {
            const auto twin = halfEdges.find({nodes.second, nodes.first});
            if (twin != halfEdges.end()) {
                mesh_.setTwin(h, twin->second);
            } else {
                mesh_.link(h,
                           side.neighbours[side.side == Side::plus ? nodes.first : nodes.second]);
            }
        }
    }

    SurfaceMesh& mesh_;
    const Wound& wound_;
    const PatchPlan& plan_;
    OneSide plus_;
    OneSide minus_;
    std::vector<int> removed_;
};

}  // namespace

std::vector<int> commitPatch(SurfaceMesh& mesh, const Wound& wound, const PatchPlan& plan,
                             CutDelta& delta) {
    return PatchCommit(mesh, wound, plan).run(delta);
}

}  // namespace kerf::cut
