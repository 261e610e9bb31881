#pragma once

#include "app/cli/replay/film.h"

namespace CLI {  // NOLINT(readability-identifier-naming): a name of its authors
class App;
class Option;
}  // namespace CLI

// What options of several verbs have in common. Checks return why a text is refused, or nothing.
namespace kerf::app {

/// Refuses an empty name, usually an unset variable of a script.
std::string refuseEmpty(const std::string& text);
/// Takes a length above zero.
std::string refuseNoLength(const std::string& text);
/// Throws InputError if the folder for results is a file.
void refuseFileAsFolder(const std::filesystem::path& out);

/// A number and nothing else.
std::optional<double> readNumber(const std::string& text);

/// `--out DIR`, a folder.
CLI::Option* addOut(CLI::App& verb, std::filesystem::path& out, const char* about);
/// `--size WxH`, the size of a picture.
CLI::Option* addPictureSize(CLI::App& verb, std::function<void(const PictureSize&)> take,
                            const char* about);
/// `--jobs N`: parallel runs, by default one per core.
void addJobs(CLI::App& verb, int& jobs);

}  // namespace kerf::app
