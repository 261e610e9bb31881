#pragma once

namespace kerf::app {

/// Names of the builtin models: sphere20, sphere80, sphere768, banana, octopus.
const std::vector<std::string>& builtinModels();
/// The file of a builtin model below assets/models. Throws InputError for an unknown name.
std::filesystem::path builtinModelFile(const std::string& name);

}  // namespace kerf::app
