// The decoder of PNG, compiled here so that the fuzzer sees into it and the sanitizers watch
// it. The library of the system is left out then.
#if defined(__clang__)
#pragma clang diagnostic ignored "-Weverything"
#endif
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
