#pragma once

#include <pybind11/pybind11.h>

namespace kerf::python {

// Each adds a part of the module kerf._native; python/kerf gives people names and types for it.
void addReport(pybind11::module_& module);
void addRun(pybind11::module_& module);
void addStudy(pybind11::module_& module);

}  // namespace kerf::python
