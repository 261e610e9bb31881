#include "app/import/repair/surface_meshing.h"

// CGAL's meshing is under the GPL, as its union is: kerf-import, a program of its own, is too.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include "sim/base/containers.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/triangle.h"
#include "sim/repair/soup_editing.h"

namespace kerf::app {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

constexpr int kRounds = 10;
constexpr double kHardAngle = 40;   // [degrees]
constexpr double kRounding = 1e-9;  // of a volume

Vec3 placeOf(const Mesh& mesh, Vertex v) {
    const Kernel::Point_3& p = mesh.point(v);
    return {p.x(), p.y(), p.z()};
}

/// With the numbers of the soup, or nothing where it is not manifold and oriented.
std::optional<Mesh> meshOf(const TriangleSoup& soup) {
    Mesh mesh;
    for (const Vec3& p : soup.positions) {
        mesh.add_vertex({p.x(), p.y(), p.z()});
    }
    for (const auto& [a, b, c] : soup.triangles) {
        if (mesh.add_face(Vertex(a), Vertex(b), Vertex(c)) == Mesh::null_face()) {
            return std::nullopt;
        }
    }
    return mesh;
}

Triangle cornersOf(const Mesh& mesh, Face face) {
    Triangle corners;
    std::ranges::transform(mesh.vertices_around_face(mesh.halfedge(face)), corners.begin(),
                           [](Vertex v) { return static_cast<int>(v.idx()); });
    return corners;
}

// --- Holes -----------------------------------------------------------------------------------

/// By Liepa (2003): of all triangulations, or, which is fast, of those in a Delaunay triangulation.
std::vector<Face> triangulated(Mesh& mesh, Mesh::Halfedge_index border, std::size_t edges) {
    constexpr std::size_t kMostOfAll = 500;  // since the search takes their cube
    std::vector<Face> patch;
    pmp::triangulate_hole(mesh, border, std::back_inserter(patch),
                          CGAL::parameters::do_not_use_cubic_algorithm(edges > kMostOfAll));
    return patch;
}

std::vector<Kernel::Point_3> pointsAround(const Mesh& mesh, Mesh::Halfedge_index border) {
    std::vector<Kernel::Point_3> points;
    for (const Vertex v : mesh.vertices_around_face(border)) {
        points.push_back(mesh.point(v));
    }
    return points;
}

/// As where holes that touched in a vertex were parted: evened, triangles there have no area.
bool touchesItself(std::vector<Kernel::Point_3> border) {
    std::ranges::sort(border, [](const auto& a, const auto& b) { return a < b; });
    return std::ranges::adjacent_find(border) != border.end();
}

/// Edges of the border are not divided: beside much longer ones than the wanted, others would be
/// so without end. CGAL takes up to 4/3 of it.
double edgeFor(const std::vector<Kernel::Point_3>& border) {
    constexpr double kMostOfWanted = 1.3;
    double sum = 0;
    double longest = 0;
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Kernel::Point_3& next = border[(i + 1) % border.size()];
        const double length = std::sqrt(CGAL::squared_distance(border[i], next));
        sum += length;
        longest = std::max(longest, length);
    }
    return std::max(sum / static_cast<double>(border.size()), longest / kMostOfWanted);
}

/// As a soap film: nothing holds the triangles to where they were. Of a closed mesh: CGAL wants the
/// edges of other holes to be as short.
void makeEven(Mesh& mesh, const std::vector<Face>& patch, double edge) {
    pmp::isotropic_remeshing(
        patch, edge, mesh,
        CGAL::parameters::number_of_iterations(kRounds).protect_constraints(true).do_project(
            false));
}

/// Adds the triangles of the mesh that the soup has not, and their vertices. Returns how many.
int addPatches(const Mesh& mesh, TriangleSoup& soup) {
    const std::size_t before = soup.triangles.size();
    std::map<int, int> added;
    const auto old = static_cast<int>(soup.positions.size());
    for (const Face face : mesh.faces()) {
        if (face.idx() < before) {
            continue;
        }
        Triangle& corners = soup.triangles.emplace_back(cornersOf(mesh, face));
        for (int& v : corners) {
            if (v >= old) {
                const auto [place, isNew] =
                    added.try_emplace(v, static_cast<int>(soup.positions.size()));
                if (isNew) {
                    soup.positions.push_back(placeOf(mesh, Vertex(v)));
                }
                v = place->second;
            }
        }
    }
    resizeAttributes(soup.skin, soup.triangles.size());
    return static_cast<int>(soup.triangles.size() - before);
}

// --- The whole surface -----------------------------------------------------------------------

/// The surface before it was remeshed.
class OldSurface {
  public:
    explicit OldSurface(const TriangleSoup& soup)
        : soup_{soup.positions, soup.triangles, {}},
          nearest_(numbers(), [this](int t) { return repair::cornersOf(soup_, t); }) {}

    Vec3 nearest(const Vec3& place) { return nearest_.closestPoint(place); }

  private:
    std::vector<int> numbers() const {
        std::vector<int> all(soup_.triangles.size());
        std::iota(all.begin(), all.end(), 0);
        return all;
    }

    TriangleSoup soup_;
    NearestTriangle nearest_;
};

std::vector<Vec3> normalsOf(const TriangleSoup& soup) {
    std::vector<Vec3> normals(soup.positions.size(), Vec3::Zero());
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        for (const int v : soup.triangles[t]) {
            normals[v] += areaNormal(repair::cornersOf(soup, t));
        }
    }
    for (Vec3& normal : normals) {
        normal.stableNormalize();
    }
    return normals;
}

/// Edges of a round surface cut corners: it moves out by what that has cost, a hair everywhere.
void restoreVolumes(TriangleSoup& soup, const std::vector<int>& parts,
                    const std::vector<double>& wanted) {
    const std::vector<double> volumes = repair::volumesOf(soup, parts);
    const std::vector<double> areas = repair::areasOf(soup, parts);
    std::vector<double> way(soup.positions.size(), 0);
    for (std::size_t t = 0; t < parts.size(); ++t) {
        const double lost = wanted[parts[t]] - volumes[parts[t]];
        for (const int v : soup.triangles[t]) {
            way[v] = std::abs(lost) > kRounding * std::abs(wanted[parts[t]])
                         ? lost / areas[parts[t]]
                         : 0;
        }
    }
    const std::vector<Vec3> normals = normalsOf(soup);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        soup.positions[v] += way[v] * normals[v];
    }
}

/// Between lines that stay, each patch of a surface remembers a triangle that it had.
class Remeshing {
  public:
    explicit Remeshing(const TriangleSoup& soup)
        : mesh_(meshOf(soup).value()),
          old_(soup),
          hard_(mesh_.add_property_map<Mesh::Edge_index, bool>("e:hard", false).first),
          patch_(mesh_.add_property_map<Face, std::size_t>("f:patch", 0).first) {
        pmp::detect_sharp_edges(mesh_, kHardAngle, hard_);
        if (!soup.skin.materials.empty()) {
            keepMaterialsApart(soup.skin.materials);
        }
        pmp::connected_components(mesh_, patch_, CGAL::parameters::edge_is_constrained_map(hard_));
        for (const Face face : mesh_.faces()) {
            oldTriangles_.try_emplace(patch_[face], static_cast<int>(face.idx()));
        }
    }

    /// One round after Botsch and Kobbelt (2004).
    void even(double edge) {
        const auto onOldSurface = [this](Vertex v) {
            const Vec3 place = old_.nearest(placeOf(mesh_, v));
            return Kernel::Point_3(place.x(), place.y(), place.z());
        };
        pmp::isotropic_remeshing(mesh_.faces(), edge, mesh_,
                                 CGAL::parameters::edge_is_constrained_map(hard_)
                                     .face_patch_map(patch_)
                                     .projection_functor(onOldSurface));
    }

    /// Replaces the triangles of the soup. Returns one that was in the place of each.
    std::vector<int> writeTo(TriangleSoup& soup) {
        mesh_.collect_garbage();
        soup.positions.clear();
        soup.triangles.clear();
        for (const Vertex v : mesh_.vertices()) {
            soup.positions.push_back(placeOf(mesh_, v));
        }
        std::vector<int> before;
        for (const Face face : mesh_.faces()) {
            soup.triangles.push_back(cornersOf(mesh_, face));
            before.push_back(oldTriangles_.at(patch_[face]));
        }
        return before;
    }

  private:
    void keepMaterialsApart(const std::vector<int>& materials) {
        for (const auto edge : mesh_.edges()) {
            const auto side = mesh_.halfedge(edge);
            hard_[edge] = hard_[edge] || materials[mesh_.face(side)] !=
                                             materials[mesh_.face(mesh_.opposite(side))];
        }
    }

    Mesh mesh_;
    OldSurface old_;
    Mesh::Property_map<Mesh::Edge_index, bool> hard_;
    Mesh::Property_map<Face, std::size_t> patch_;
    std::map<std::size_t, int> oldTriangles_;  ///< by patch
};

}  // namespace

HoleFilling fillHoles(TriangleSoup& welded, bool evenly) {
    HoleFilling done;
    std::optional<Mesh> mesh = meshOf(welded);
    if (!mesh) {
        return done;
    }
    std::vector<Mesh::Halfedge_index> borders;
    pmp::extract_boundary_cycles(*mesh, std::back_inserter(borders));
    std::vector<std::pair<std::vector<Face>, double>> toMakeEven;
    for (const auto border : borders) {
        const std::vector<Kernel::Point_3> points = pointsAround(*mesh, border);
        const std::vector<Face> patch = triangulated(*mesh, border, points.size());
        done.holes += patch.empty() ? 0 : 1;
        if (evenly && !patch.empty() && !touchesItself(points)) {
            toMakeEven.emplace_back(patch, edgeFor(points));
        }
    }
    if (CGAL::is_closed(*mesh)) {
        for (const auto& [patch, edge] : toMakeEven) {
            makeEven(*mesh, patch, edge);
        }
    }
    done.triangles = addPatches(*mesh, welded);
    return done;
}

void remesh(TriangleSoup& soup, double edge, const std::function<void(int round)>& onRound) {
    const std::vector<int> parts = repair::partsOf(soup);
    const std::vector<double> volumes = repair::volumesOf(soup, parts);
    Remeshing work(soup);
    for (int round = 0; round < kRounds; ++round) {
        if (onRound) {
            onRound(round);
        }
        work.even(edge);
    }
    const std::vector<int> before = work.writeTo(soup);
    const auto asBefore = [&](const std::vector<int>& values) {
        return mapped(before, [&](int t) { return values[t]; });
    };
    restoreVolumes(soup, asBefore(parts), volumes);
    soup.skin.uvs.clear();
    soup.skin.colors.clear();
    if (!soup.skin.materials.empty()) {
        soup.skin.materials = asBefore(soup.skin.materials);
    }
}

}  // namespace kerf::app
