#pragma once

#include "app/study/run_record.h"

namespace kerf::app {

/// Most runs that are drawn, and how many share a picture.
inline constexpr std::size_t kMostDrawnRuns = 240;
inline constexpr std::size_t kRunsPerPicture = 60;

/// Names of the pictures of a study: volume.png, and volume-2.png for more runs; the same of the
/// kinetic energy and of the time of a step.
std::vector<std::string> studyPictures(const Study& study);
/// Draws small multiples of the runs of a study, a panel for each, with the current OpenGL context,
/// into the studyPictures() in `out`. Throws InputError and OutputError.
void drawStudy(const Study& study, const std::filesystem::path& out);

/// The number of panels in a row, so that columns have the same value of the parameter that varies
/// fastest, if it has few.
int panelColumns(const Study& study);

}  // namespace kerf::app
