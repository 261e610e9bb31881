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
        .def_property_readonly("step", reported<&StepReport::step>)
        .def_property_readonly("time", reported<&StepReport::time>)
        .def_property_readonly("volume", reported<&StepReport::volume>)
        .def_property_readonly("volume_ratio", reported<&StepReport::volumeRatio>)
        .def_property_readonly("pieces", reported<&StepReport::pieces>)
        .def_property_readonly("vertices", reported<&StepReport::vertices>)
        .def_property_readonly("triangles", reported<&StepReport::triangles>)
        .def_property_readonly("ispcs", reported<&StepReport::ispcs>)
        .def_property_readonly("touched_triangles", reported<&StepReport::touchedTriangles>)
        .def_property_readonly("closed", reported<&StepReport::closed>)
        .def_property_readonly("deform_ms", reported<&StepReport::deformMs>)
        .def_property_readonly("collide_ms", reported<&StepReport::collideMs>)
        .def_property_readonly("cut_ms", reported<&StepReport::cutMs>)
        .def_readonly("render_ms", &MetricsRow::renderMs)
        .def_readonly("frame_ms", &MetricsRow::frameMs)
        .def_property_readonly("contacts", reported<&StepReport::contacts>)
        .def_property_readonly("one_to_four", divided<SubdivisionPattern::oneToFour>)
        .def_property_readonly("one_to_three_a", divided<SubdivisionPattern::oneToThreeA>)
        .def_property_readonly("one_to_two", divided<SubdivisionPattern::oneToTwo>)
        .def_property_readonly("one_to_three_b", divided<SubdivisionPattern::oneToThreeB>)
        .def_property_readonly(
            "other_patterns",
            [](const MetricsRow& row) { return otherPatterns(row.report.subdivisions); })
        .def_property_readonly("seeds", reported<&StepReport::seeds>)
        .def_property_readonly("kinetic_energy", reported<&StepReport::kineticEnergy>)
        .def_property_readonly("potential_energy", reported<&StepReport::potentialEnergy>)
        .def_property_readonly("debris_pieces",
                               [](const MetricsRow& row) { return row.report.debris.pieces; })
        .def_property_readonly("debris_volume",
                               [](const MetricsRow& row) { return row.report.debris.volume; })
        .def_property_readonly("strain_energy", reported<&StepReport::strainEnergy>)
        .def_property_readonly("lost_pieces", reported<&StepReport::lostPieces>)
        .def_property_readonly("search_ms", searched<&SearchWork::milliseconds>)
        .def_property_readonly("search_walk_ms", searched<&SearchWork::walkMilliseconds>)
        .def_property_readonly("search_seeds", searched<&SearchWork::seeds>)
        .def_property_readonly("search_tests", searched<&SearchWork::tests>)
        .def_property_readonly("swept_area",
                               [](const MetricsRow& row) { return row.report.swept.asItLay; })
        .def_property_readonly("swept_area_at_rest",
                               [](const MetricsRow& row) { return row.report.swept.atRest; })
        .def_readonly("fracture_energy", &MetricsRow::fractureEnergy)
        .def_property_readonly("blade_force", felt<&BladeLoad::force>)
        .def_property_readonly("blade_moment", felt<&BladeLoad::moment>)
        .def(
            "as_dict",
            [](const MetricsRow& row) {
                return py::module_::import("json").attr("loads")(app::formatJsonLine(row));
            },
            "A row of metrics.csv: its columns, an empty cell being None.");
}

}  // namespace kerf::python
