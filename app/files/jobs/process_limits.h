#pragma once

namespace kerf::app {

/// The environment variables with the limits of a process: seconds of CPU time, bytes of address
/// space.
inline constexpr char kCpuVariable[] = "KERF_IMPORT_CPU_SECONDS";
inline constexpr char kMemoryVariable[] = "KERF_IMPORT_ADDRESS_SPACE";

/// Applies the limits passed on by the parent: CPU time, address space, no core file. Called first
/// by the child.
void applyImportLimits();

/// Most seconds that a model may take once it is read, of processor time as of any.
inline constexpr int kMendingWallSeconds = 600;
/// Exchanges the limits for those of inspecting and mending a model, which was read: ten minutes,
/// 16 GiB.
void allowMending();
/// Ends this process once it has taken so much processor time (SIGXCPU).
void limitProcessorTime(unsigned seconds);

}  // namespace kerf::app
