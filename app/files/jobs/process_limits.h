#pragma once

namespace kerf::app {

/// The environment variables with the limits of a process: seconds of CPU time, bytes of address
/// space.
inline constexpr char kCpuVariable[] = "KERF_IMPORT_CPU_SECONDS";
inline constexpr char kMemoryVariable[] = "KERF_IMPORT_ADDRESS_SPACE";

/// Applies the limits passed on by the parent: CPU time, address space, no core file. Called first
/// by the child.
void applyImportLimits();

}  // namespace kerf::app
