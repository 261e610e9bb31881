#include <pybind11/stl.h>

#include "app/files/io/output_folder.h"
#include "app/study/study_run.h"
#include "app/study/study_table.h"
#include "gpu/context.h"
#include "python/bindings.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

/// The exit code of a run and what went wrong in it. Each is a program of its own.
std::pair<int, std::string> performRun(const app::Study& study, std::size_t number,
                                       const std::string& out) {
    const py::gil_scoped_release unlocked;
    const app::RunEnd end = app::performRun(study, number, out);
    if (end.noOpenGl) {
        throw gpu::ContextError(end.log);
    }
    return {end.record.exitCode, end.record.problem};
}

using Numbers = std::vector<std::size_t>;

/// Runs that failed, and those that are missing.
std::pair<Numbers, Numbers> gather(const app::Study& study, const std::string& out) {
    const py::gil_scoped_release unlocked;
    const app::StudyTable table = app::gatherTable(study, out);
    app::OutputFolder(out).write(app::kTableFile, table.text);
    return {table.failed, table.missing};
}

}  // namespace

void addStudy(py::module_& module) {
    py::class_<app::Study>(module, "Study")
        .def(py::init([](const std::string& file) { return app::readStudy(file); }))
        .def("__len__", [](const app::Study& study) { return study.runs.size(); })
        .def("describe",
             [](const app::Study& study, std::size_t number) {
                 const app::StudyRun& run = study.runs.at(number);
                 std::vector<std::pair<std::string, std::string>> settings;
                 for (const app::Setting& setting : run.settings) {
                     settings.emplace_back(setting.name, setting.value);
                 }
                 return std::pair(study.sessionOf(run).name, settings);
             })
        .def("run", performRun)
        .def("gather", gather);
}

}  // namespace kerf::python
