// kerf-unite FILE: makes one surface of pieces that cross. A program of its own, started by Kerf,
// since CGAL's union of meshes is under the GPL; so is this program once it is linked.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <list>
#include <stdexcept>

#include "app/files/import/shell_protocol.h"
#include "app/files/jobs/process_limits.h"

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using kerf::app::ShellMessage;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

ShellMessage readShells(const char* file) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::optional<ShellMessage> message = kerf::app::decodeShells(bytes);
    if (!message || message->pieces.empty()) {
        throw std::runtime_error("the pieces did not arrive whole");
    }
    return std::move(*message);
}

Mesh meshOf(const ShellMessage& shells, int piece) {
    Mesh mesh;
    std::map<int, Mesh::Vertex_index> vertices;
    const auto vertexFor = [&](int v) {
        const auto found = vertices.find(v);
        if (found != vertices.end()) {
            return found->second;
        }
        const auto& [x, y, z] = shells.positions[v];
        return vertices.emplace(v, mesh.add_vertex({x, y, z})).first->second;
    };
    for (std::size_t t = 0; t < shells.triangles.size(); ++t) {
        if (shells.pieces[t] != piece) {
            continue;
        }
        const auto& [a, b, c] = shells.triangles[t];
        if (mesh.add_face(vertexFor(a), vertexFor(b), vertexFor(c)) == Mesh::null_face()) {
            throw std::runtime_error("a piece is not manifold");
        }
    }
    if (!pmp::does_bound_a_volume(mesh)) {
        throw std::runtime_error("a piece encloses no volume");
    }
    return mesh;
}

/// Whether `whole` became one surface with the piece; else it stays as it was.
bool unite(Mesh& whole, Mesh piece) {
    Mesh before = whole;
    if (pmp::corefine_and_compute_union(whole, piece, whole,
                                        CGAL::parameters::throw_on_self_intersection(true))) {
        return true;
    }
    whole = std::move(before);
    return false;
}

/// Kernel numbers are exact, so that the result of one union can go into the next. What would touch
/// in a line or a point alone waits for the others, which may fill the place.
Mesh united(const ShellMessage& shells) {
    const int pieces = *std::ranges::max_element(shells.pieces) + 1;
    Mesh whole = meshOf(shells, 0);
    std::list<Mesh> waiting;
    for (int piece = 1; piece < pieces; ++piece) {
        waiting.push_back(meshOf(shells, piece));
    }
    while (!waiting.empty()) {
        if (waiting.remove_if([&](const Mesh& piece) { return unite(whole, piece); }) == 0) {
            throw std::runtime_error(
                "the pieces touch in a line or a point, so their union is no "
                "surface that can be cut");
        }
    }
    whole.collect_garbage();
    return whole;
}

ShellMessage messageOf(const Mesh& mesh) {
    ShellMessage message;
    for (const auto v : mesh.vertices()) {
        const Kernel::Point_3& p = mesh.point(v);
        message.positions.push_back(
            {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    for (const auto face : mesh.faces()) {
        std::array<int, 3> corners{};
        std::size_t i = 0;
        for (const auto v : mesh.vertices_around_face(mesh.halfedge(face))) {
            corners.at(i++) = static_cast<int>(v.idx());
        }
        message.triangles.push_back(corners);
    }
    message.pieces.assign(message.triangles.size(), 0);
    return message;
}

ShellMessage answerFor(const char* file) {
    try {
        return messageOf(united(readShells(file)));
    } catch (const pmp::Corefinement::Self_intersection_exception&) {
        return {.failure = "a piece passes through itself"};
    } catch (const std::bad_alloc&) {
        return {.failure = "it needs more memory than there is"};
    } catch (const std::exception& error) {
        return {.failure = error.what()};
    }
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) {
        std::cerr << "kerf-unite: Kerf starts this program to unite pieces that cross; use "
                     "kerf inspect MODEL --repair OUT.\n";
        return 2;
    }
    kerf::app::applyImportLimits();
    const std::string bytes = kerf::app::encodeShells(answerFor(words[1]));
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    return std::cout.good() ? 0 : 1;
}
