#include <pybind11/stl.h>

#include "app/session/metrics.h"
#include "python/bindings.h"

namespace kerf::python {
namespace {

namespace py = pybind11;
using app::MetricsRow;

template <Vec3 BladeLoad::*part>
std::optional<py::object> felt(const MetricsRow& row) {
    if (const std::optional<BladeLoad>& load = row.report.bladeLoad) {
        const Vec3& v = (*load).*part;
        return py::module_::import("numpy").attr("array")(py::make_tuple(v[0], v[1], v[2]));
    }
    return std::nullopt;
}

}  // namespace

void addReport(py::module_& module) {
    py::class_<MetricsRow> report(
        module, "Report",
        "The measurements of a step: the columns of metrics.csv under the same names.");
    for (const app::MetricsColumn& column : app::metricsColumns()) {
        if (*column.meaning != '\0') {
            report.def_property_readonly(std::string(column.name).c_str(), column.value,
                                         column.meaning);
        }
    }
    report
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
            "A row of metrics.csv: its columns; None for an empty cell.");
}

}  // namespace kerf::python
