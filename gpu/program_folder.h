#pragma once

#include <filesystem>

namespace kerf::gpu {

/// The folder of the program kerf: that of the executable, unless setProgramFolder() named another.
std::filesystem::path programFolder();
/// For code that runs in a program of somebody else, such as Python.
void setProgramFolder(std::filesystem::path folder);

}  // namespace kerf::gpu
