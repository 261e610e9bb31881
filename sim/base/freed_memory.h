#pragma once

namespace kerf {

/// From now on the process keeps freed memory, up to some hundred megabytes, for reuse: new pages
/// from the system take a tenth of the time of a cut. For the start of a program; does nothing
/// without glibc's allocator.
void keepFreedMemory();

/// Returns kept memory to the system, in some milliseconds: for when something large has ended.
/// Does nothing without glibc's allocator.
void giveBackFreedMemory();

}  // namespace kerf
