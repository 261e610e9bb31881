#pragma once

namespace kerf::gpu {

/// The path of data such as "assets/models": below $KERF_DATA_DIR if set, else beside or one above
/// the folder of the executable, else in ../share/kerf of that folder (installed), else in the
/// source tree that it was built from.
std::filesystem::path dataPath(std::string_view relative);

/// The file or folder of that name which Kerf keeps in one of the XDG base directories: below
/// `variable`, if an absolute path, else below `usual` in the home folder; empty without a home.
std::filesystem::path userPath(const char* variable, const char* usual, std::string_view name);
/// That of Kerf's state: $XDG_STATE_HOME/kerf/NAME, by default below ~/.local/state.
std::filesystem::path statePath(std::string_view name);

/// dataPath("shaders").
std::filesystem::path shaderRoot();

/// The folder of the program kerf: that of the executable, unless setProgramFolder() named another.
std::filesystem::path programFolder();
/// For code that runs in another program, such as Python.
void setProgramFolder(std::filesystem::path folder);

}  // namespace kerf::gpu
