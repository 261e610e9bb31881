#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/files/import_protocol.h"

struct aiScene;

namespace kerf::app {

/// The materials that the meshes of a scene use, and the bytes of their pictures: those in `file`
/// itself, and regular files of limited size in its folder and below. What is missing there is a
/// sentence of the answer. Fills in what the triangles of `model` have of them; those come mesh by
/// mesh, as many of each as `triangles` says. `file` names the model.
void addAppearance(const aiScene& scene, const std::filesystem::path& file,
                   const std::vector<int>& triangles, ImportedModel& model);

/// Gives all triangles of a model in `file` one material with the picture of that name. One that is
/// missing is a sentence of the answer.
void addImageMaterial(const std::filesystem::path& file, const std::string& image,
                      ImportedModel& model);

/// Whether a file is of the kinds that give colours in linear light.
bool isGltf(const std::filesystem::path& file);

/// Whether `file` lies in the folder or below, and is regular and not larger than a model may be.
/// `folder` must be canonical.
bool isFileBelow(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace kerf::app
