#pragma once

namespace kerf::app {

/// The environment variables by which a process learns its limits: seconds of CPU time, bytes of
/// address space.
inline constexpr char kCpuVariable[] = "KERF_IMPORT_CPU_SECONDS";
inline constexpr char kMemoryVariable[] = "KERF_IMPORT_ADDRESS_SPACE";

/// Takes the limits that the parent passed on to this process: CPU time, address space, no core
/// file. Called first by the child.
void applyImportLimits();

}  // namespace kerf::app
