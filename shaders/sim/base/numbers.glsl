// The words that a kernel gets with a dispatch: gpu/numbers_table.h. The only uniform block.
layout(std140, binding = 0) uniform Numbers { uvec4 numbers; };
