#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <optional>

#include "app/session/metrics.h"
#include "python/bindings.h"

namespace kerf::python {
namespace {

namespace py = pybind11;
using app::MetricsRow;

/// A property that is a member of the report.
template <auto member>
auto reported(const MetricsRow& row) {
    return row.report.*member;
}

template <auto member>
auto searched(const MetricsRow& row) {
    return row.report.search.*member;
}

template <double HeldEdge::*part>
double held(const MetricsRow& row) {
    return row.report.heldEdge.*part;
}

template <SubdivisionPattern pattern>
int divided(const MetricsRow& row) {
    return row.report.subdivisions[static_cast<std::size_t>(pattern)];
}

template <Vec3 BladeLoad::*part>
std::optional<py::array_t<double>> felt(const MetricsRow& row) {
    const std::optional<BladeLoad>& load = row.report.bladeLoad;
    return load ? std::optional(py::array_t<double>(3, ((*load).*part).data())) : std::nullopt;
}

}  // namespace

void addReport(py::module_& module) {
    py::class_<MetricsRow>(
        module, "Report",
        "The measures of a step: the columns of metrics.csv under the same names.")
        .def_property_readonly("step", reported<&StepReport::step>, "Number of the step, from 0.")
        .def_property_readonly("time", reported<&StepReport::time>,
                               "Simulated time at its end [s].")
        .def_property_readonly("volume", reported<&StepReport::volume>,
                               "Of all pieces together [m³].")
        .def_property_readonly("volume_ratio", reported<&StepReport::volumeRatio>,
                               "Share of the volume in that of the uncut shape at rest.")
        .def_property_readonly("pieces", reported<&StepReport::pieces>,
                               "Number of pieces after the step.")
        .def_property_readonly("vertices", reported<&StepReport::vertices>,
                               "Number of vertices after the step.")
        .def_property_readonly("triangles", reported<&StepReport::triangles>,
                               "Number of triangles after the step.")
        .def_property_readonly("ispcs", reported<&StepReport::ispcs>,
                               "Number of internal shape-preserving constraints after the step.")
        .def_property_readonly("touched_triangles", reported<&StepReport::touchedTriangles>,
                               "Triangles that the cut divided in the step.")
        .def_property_readonly("closed", reported<&StepReport::closed>,
                               "Whether the mesh is a closed, oriented 2-manifold after the step.")
        .def_property_readonly("deform_ms", reported<&StepReport::deformMs>,
                               "Wall-clock time of the solver [ms].")
        .def_property_readonly("collide_ms", reported<&StepReport::collideMs>,
                               "Wall-clock time of contact [ms].")
        .def_property_readonly("cut_ms", reported<&StepReport::cutMs>,
                               "Wall-clock time of the cut [ms].")
        .def_readonly("render_ms", &MetricsRow::renderMs,
                      "Wall-clock time of the pictures before the step [ms].")
        .def_readonly("frame_ms", &MetricsRow::frameMs,
                      "Wall-clock time of the step with its events [ms].")
        .def_property_readonly("contacts", reported<&StepReport::contacts>,
                               "Contacts of the body with itself in the last substep.")
        .def_property_readonly("one_to_four", divided<SubdivisionPattern::oneToFour>,
                               "Touched triangles that were divided by the paper's pattern 1:4.")
        .def_property_readonly("one_to_three_a", divided<SubdivisionPattern::oneToThreeA>,
                               "Touched triangles that were divided by the paper's pattern 1:3A.")
        .def_property_readonly("one_to_two", divided<SubdivisionPattern::oneToTwo>,
                               "Touched triangles that were divided by the paper's pattern 1:2.")
        .def_property_readonly("one_to_three_b", divided<SubdivisionPattern::oneToThreeB>,
                               "Touched triangles that were divided by the paper's pattern 1:3B.")
        .def_property_readonly(
            "other_patterns",
            [](const MetricsRow& row) { return otherPatterns(row.report.subdivisions); },
            "Touched triangles that were divided in none of the paper's ways.")
        .def_property_readonly("seeds", reported<&StepReport::seeds>,
                               "Groups of neighbours among the touched triangles.")
        .def_property_readonly("kinetic_energy", reported<&StepReport::kineticEnergy>,
                               "Of the vertices that are not pinned [J].")
        .def_property_readonly(
            "potential_energy", reported<&StepReport::potentialEnergy>,
            "In the field of gravity, above the floor, or above 0 without one [J].")
        .def_property_readonly(
            "debris_pieces", [](const MetricsRow& row) { return row.report.debris.pieces; },
            "Pieces removed in the step, being smaller than debris_volume.")
        .def_property_readonly(
            "debris_volume", [](const MetricsRow& row) { return row.report.debris.volume; },
            "Their volume at rest [m³].")
        .def_property_readonly("strain_energy", reported<&StepReport::strainEnergy>,
                               "Of the strained material [J]; None with the solver \"pbd\".")
        .def_property_readonly(
            "lost_pieces", reported<&StepReport::lostPieces>,
            "Pieces that ran away in the step and were taken back to where it began.")
        .def_property_readonly("search_ms", searched<&SearchWork::milliseconds>,
                               "Part of cut_ms: finding the triangles near the blade [ms].")
        .def_property_readonly(
            "search_walk_ms", searched<&SearchWork::walkMilliseconds>,
            "Part of search_ms, with cut_search \"adjacency\": until the first walk was over [ms].")
        .def_property_readonly(
            "search_seeds", searched<&SearchWork::seeds>,
            "With cut_search \"adjacency\": groups of neighbours near the blade.")
        .def_property_readonly("search_tests", searched<&SearchWork::tests>,
                               "Triangles that were tested in the search.")
        .def_property_readonly(
            "swept_area", [](const MetricsRow& row) { return row.report.swept.asItLay; },
            "That the blade swept inside of the material, one side, where the body lies [m²].")
        .def_property_readonly(
            "swept_area_at_rest", [](const MetricsRow& row) { return row.report.swept.atRest; },
            "The same, at rest [m²].")
        .def_property_readonly(
            "fracture_energy",
            [](const MetricsRow& row) {
                return row.namesToughness ? std::optional(row.report.fractureEnergy) : std::nullopt;
            },
            "That the new surface of the step takes, by the toughness [J]; None where nobody named "
            "one.")
        .def_property_readonly("blade_work", held<&HeldEdge::work>,
                               "Of what led the blade in the step against its edge [J]; 0 unless "
                               "the blade feels.")
        .def_property_readonly("blade_energy", held<&HeldEdge::energy>,
                               "In the spring that holds the edge back [J].")
        .def_property_readonly("blade_lag", held<&HeldEdge::lag>,
                               "How far the edge is behind where the blade is led, a mean [m].")
        .def_property_readonly(
            "blade_force", felt<&BladeLoad::force>,
            "On the blade's body, as a mean over the step [N]; None unless forces are measured.")
        .def_property_readonly("blade_moment", felt<&BladeLoad::moment>,
                               "Of the same, about the middle of the plate behind its bevel [N m].")
        .def(
            "as_dict",
            [](const MetricsRow& row) {
                return py::module_::import("json").attr("loads")(app::formatJsonLine(row));
            },
            "A row of metrics.csv: its columns, an empty cell being None.");
}

}  // namespace kerf::python
