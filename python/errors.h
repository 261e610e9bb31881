#pragma once

#include <pybind11/pybind11.h>

namespace kerf::python {

/// Adds kerf.Error and its kinds to the module, and translates Kerf's exceptions into them, with
/// the messages of the command line.
void addErrors(pybind11::module_& module);

}  // namespace kerf::python
