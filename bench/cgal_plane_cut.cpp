#include "bench/cgal_plane_cut.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

namespace kerf {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;
using HalfEdge = Mesh::Halfedge_index;

// The borders that split() leaves have about half the edge length of the skin. This fills them at
// about the skin's; the default of sqrt(2) gives three times as many triangles.
constexpr double kDensity = 0.8;

Mesh meshOf(const SurfaceMesh& mesh) {
    Mesh result;
    for (const Vec3& p : mesh.positions()) {
        result.add_vertex({p.x(), p.y(), p.z()});
    }
    for (const int t : livingTriangles(mesh)) {
        const auto vertex = [&](int corner) {
            return Mesh::Vertex_index(mesh.triangle(t)[corner]);
        };
        result.add_face(vertex(0), vertex(1), vertex(2));
    }
    return result;
}

}  // namespace

struct CgalPlaneCut::State {
    Mesh mesh;
    int wallTriangles = 0;
};

CgalPlaneCut::CgalPlaneCut(const SurfaceMesh& mesh) : state_(new State{meshOf(mesh)}) {}

CgalPlaneCut::~CgalPlaneCut() = default;

void CgalPlaneCut::run(const Vec3& point, const Vec3& normal) {
    Mesh& mesh = state_->mesh;
    pmp::split(mesh, Kernel::Plane_3({point.x(), point.y(), point.z()},
                                     Kernel::Vector_3(normal.x(), normal.y(), normal.z())));
    std::vector<HalfEdge> borders;
    pmp::extract_boundary_cycles(mesh, std::back_inserter(borders));
    for (const HalfEdge border : borders) {
        std::vector<Face> faces;
        std::vector<Mesh::Vertex_index> vertices;
        pmp::triangulate_and_refine_hole(mesh, border, std::back_inserter(faces),
                                         std::back_inserter(vertices),
                                         CGAL::parameters::density_control_factor(kDensity));
        if (faces.empty()) {
            throw std::runtime_error("CGAL could not fill a border");
        }
        state_->wallTriangles += static_cast<int>(faces.size());
    }
}

std::vector<double> CgalPlaneCut::partVolumes() const {
    std::vector<Mesh> parts;
    pmp::split_connected_components(state_->mesh, parts);
    std::vector<double> volumes;
    volumes.reserve(parts.size());
    for (const Mesh& part : parts) {
        volumes.push_back(pmp::volume(part));
    }
    std::sort(volumes.begin(), volumes.end());
    return volumes;
}

int CgalPlaneCut::wallTriangles() const {
    return state_->wallTriangles;
}

}  // namespace kerf
