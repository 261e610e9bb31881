#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/body/body_model.h"

namespace kerf::app {

/// What the double-precision reference solver makes of a builtin model that is out of shape and in
/// motion. A test records it (tests/app/doctor/recorded_answers_test.cpp).
struct RecordedAnswers {
    BodyState start;
    /// By the name of a check, of each vertex [m]: its displacement after a phase of a substep, or
    /// its position after a whole step.
    std::map<std::string, std::vector<Vec3f>> vertices;
    double strainEnergy = 0;  ///< at the start [J]

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(start.positions, start.velocities, vertices, strainEnergy);
    }
};

/// By the name of a builtin model.
using AnswersByModel = std::map<std::string, RecordedAnswers>;

/// The file of the answers, in assets.
std::filesystem::path recordedAnswersFile();
/// Reads them. Throws InputError if the file is missing or damaged.
AnswersByModel recordedAnswers();

}  // namespace kerf::app
