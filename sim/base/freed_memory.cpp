#include "sim/base/freed_memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace kerf {

void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr int kLargestFromHeap = 32 << 20;  // [bytes], as much as glibc allows
    constexpr int kMostKept = 256 << 20;        // at the end of the heap
    mallopt(M_MMAP_THRESHOLD, kLargestFromHeap);
    mallopt(M_TRIM_THRESHOLD, kMostKept);
#endif
}

void giveBackFreedMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace kerf
