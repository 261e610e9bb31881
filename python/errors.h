#pragma once

#include <pybind11/pybind11.h>

namespace kerf::python {

/// Adds kerf.Error and its kinds to the module, and turns what Kerf throws into them, with the
/// sentences of the command line.
void addErrors(pybind11::module_& module);

}  // namespace kerf::python
