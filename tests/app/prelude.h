// What any test of the application may use without a word: what stands in three of them.
#pragma once

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "app/cli/replay/replay.h"
#include "app/doctor/findings.h"
#include "app/editor/storage/settings_file.h"
#include "app/files/export/export.h"
#include "app/files/import/builtin_models.h"
#include "app/files/import/import_process.h"
#include "app/files/import/model_source.h"
#include "app/files/io/csv.h"
#include "app/files/io/encodings.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/import/face_soup.h"
#include "app/import/model_answer.h"
#include "app/practice/score.h"
#include "app/scene/document/document_loading.h"
#include "app/scene/document/editor_document.h"
#include "app/scene/document/rest_of_body.h"
#include "app/scene/editor_scene.h"
#include "app/scene/editor_stroke.h"
#include "app/scene/held_hands.h"
#include "app/scene/timeline/scene_recorder.h"
#include "app/scene/timeline/scene_timeline.h"
#include "app/session/material.h"
#include "app/session/session.h"
#include "app/session/simulation_driver.h"
#include "gpu/data_path.h"
#include "gpu/program.h"
#include "render/scene/image.h"
#include "render/scene/picture_comparison.h"
#include "sim/base/math.h"
#include "sim/base/text.h"
#include "sim/mesh/invariants.h"
#include "sim/repair/soup_inspection.h"
#include "sim/run/simulation.h"
#include "tests/app/editor/editor_fixture.h"
#include "tests/app/session/replayed_session.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/file_fault.h"
#include "tests/support/prelude.h"
#include "tests/support/program_output.h"
#include "tests/support/refusals.h"
#include "tests/support/replaced_text.h"
#include "tests/support/run_kerf.h"
#include "tests/support/session_samples.h"
#include "tests/support/shapes.h"
#include "tests/support/simulation_fixture.h"
#include "tests/support/small_sessions.h"
#include "tests/support/written_png.h"

namespace kerf {
using Json = nlohmann::json;
}
