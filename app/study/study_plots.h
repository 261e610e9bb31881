#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/study/run_record.h"

namespace kerf::app {

/// Most runs that are drawn, and how many of them share a picture.
inline constexpr std::size_t kMostDrawnRuns = 240;
inline constexpr std::size_t kRunsPerPicture = 60;

/// Names of the pictures of a study: volume.png, and volume-2.png for more runs; the same of the
/// kinetic energy and of the time of a step.
std::vector<std::string> studyPictures(const Study& study);
/// Draws small multiples of what the runs of a study went through, a panel for each run, on the
/// OpenGL context that is current, into the studyPictures() in `out`. Throws InputError and
/// OutputError.
void drawStudy(const Study& study, const std::filesystem::path& out);

/// How many panels stand in a row, so that those below one another have the same value of the
/// parameter that varies fastest, where it has few.
int panelColumns(const Study& study);

}  // namespace kerf::app
