#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "app/files/import/builtin_models.h"
#include "app/session/material.h"
#include "app/session/paper_experiments.h"
#include "gpu/data_path.h"
#include "python/bindings.h"
#include "python/errors.h"
#include "python/log.h"
#include "sim/base/freed_memory.h"
#include "sim/base/params.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

/// A row of paramTable().
py::dict describe(const ParamInfo& param) {
    py::dict row;
    row["name"] = param.name;
    row["unit"] = param.unit;
    row["meaning"] = param.meaning;
    row["low"] = param.low;
    row["high"] = param.high;
    row["choices"] = std::vector<std::string>(param.choices.begin(), param.choices.end());
    return row;
}

py::list parameters() {
    py::list rows;
    for (const ParamInfo& param : paramTable()) {
        rows.append(describe(param));
    }
    return rows;
}

py::list paperExperiments() {
    py::list rows;
    for (const app::PaperExperiment& experiment : app::paperExperiments()) {
        py::dict row;
        row["name"] = experiment.name;
        row["label"] = experiment.label;
        row["iterations"] = experiment.iterations;
        row["triangles"] = experiment.triangles;
        row["mean_volume"] = experiment.meanVolume;
        row["mean_fps"] = experiment.meanFps;
        rows.append(row);
    }
    return rows;
}

}  // namespace

PYBIND11_MODULE(_native, module) {
    keepFreedMemory();
    catchLog();
    translateErrors();
    addReport(module);
    addRun(module);
    addStudy(module);
    module.attr("version") = KERF_VERSION;
    module.def("set_program_folder",
               [](const std::string& folder) { gpu::setProgramFolder(folder); });
    module.def("builtin_models", app::builtinModels,
               "The names of the models that come with Kerf.");
    module.def("builtin_materials", app::materialNames,
               "The names of the materials that come with Kerf.");
    module.def("paper_experiments", paperExperiments,
               "The paper's experiments in its order: `name` of model and session, `label`, "
               "`iterations`, `triangles`, `mean_volume` in percent and `mean_fps`, 0 where it has "
               "no figure.");
    module.def("parameters", parameters,
               "All parameters: `name`, `unit`, `meaning`, `low`, `high`, `choices`.");
}

}  // namespace kerf::python
