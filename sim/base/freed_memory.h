#pragma once

namespace kerf {

/// From now on the process keeps what it frees, up to some hundred megabytes, for what it asks for
/// next: to get new pages from the system takes a tenth of the time of a cut. For the start of a
/// program; does nothing but with the allocator of glibc.
void keepFreedMemory();

/// Gives back to the system what was freed and kept, in some milliseconds: for when something large
/// has ended. Does nothing but with the allocator of glibc.
void giveBackFreedMemory();

}  // namespace kerf
