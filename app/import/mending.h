#pragma once

#include "app/files/import/import_answer.h"

namespace kerf::app {

/// The report on a model, mended as ordered.
MeshReport mend(TriangleSoup& soup, const ImportOrder& order);

/// What would make a model cuttable, or unite its intersecting pieces: each repair is made on a
/// copy.
ModelHelp helpFor(const TriangleSoup& soup, const MeshReport& found);

/// Says on standard error what is done now, for the program that waits (readStage()).
void tellStage(const std::string& stage);

}  // namespace kerf::app
