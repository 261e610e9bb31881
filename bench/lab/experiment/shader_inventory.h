#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kerf::app {

/// A buffer that kernels of the simulation see, as shaders/shared/bindings.h describes it.
struct ShaderBuffer {
    int binding = 0;
    std::string name;      ///< "Positions"
    std::string size;      ///< what it has one entry for: "per vertex", "one"
    std::string contents;  ///< "base position X [m], inverse unit mass"
};

/// What the kernels of the simulation work with: our counterpart of the paper's table 1.
struct ShaderInventory {
    std::vector<ShaderBuffer> buffers;  ///< in the order of the header
    int kernels = 0;                    ///< files of compute shaders
    int threads = 0;                    ///< of a work group, in nearly every kernel
};

/// Reads the inventory from the shaders below `root`, so that it cannot be out of date. What is not
/// found there is left out. Throws InputError where a file can't be read.
ShaderInventory readShaderInventory(const std::filesystem::path& root);

}  // namespace kerf::app
