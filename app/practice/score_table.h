#pragma once

#include <nlohmann/json.hpp>

namespace kerf::app {

/// A try, and where it was read.
struct Scored {
    std::string file;
    nlohmann::ordered_json score;  ///< as toJson() has it
};

/// Whether a JSON has what toJson() writes.
bool isScore(const nlohmann::ordered_json& json);

/// By person, task, date and file.
void sortTries(std::vector<Scored>& tries);

/// A line for each try, with its figures in SI units; a cell is empty where there is none.
std::string scoresAsCsv(const std::vector<Scored>& tries);

/// One self-contained page. Throws InputError if its template can't be read.
std::string scoresAsHtml(const std::vector<Scored>& tries);

}  // namespace kerf::app
