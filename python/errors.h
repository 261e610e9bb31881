#pragma once

namespace kerf::python {

/// Translates Kerf's exceptions into those of python/kerf/_errors.py, with the messages of the
/// command line.
void translateErrors();

}  // namespace kerf::python
