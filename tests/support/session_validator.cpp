#include "tests/support/session_validator.h"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "app/session/session.h"
#include "tests/paths.h"
#include "tests/support/session_schema.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace {

std::string quoted(const std::filesystem::path& path) {
    return " '" + path.string() + "'";
}

}  // namespace

bool hasSchemaValidator() {
    return std::system("/usr/bin/python3 -c 'import jsonschema' 2>/dev/null") == 0;
}

std::vector<std::vector<std::string>> placesWrongBySchema(const std::vector<std::string>& texts) {
    const TemporaryFolder folder;
    writeText(folder / "schema.json", app::sessionSchema());
    writeText(folder / "texts.json", nlohmann::json(texts).dump());
    const std::string call = "/usr/bin/python3 -B '" KERF_SOURCE_DIR
                             "/tests/support/validate_sessions.py'" +
                             quoted(folder / "schema.json") + quoted(folder / "texts.json") + " >" +
                             quoted(folder / "places");
    if (std::system(call.c_str()) != 0) {
        throw std::runtime_error("the validator failed, see above");
    }
    std::vector<std::vector<std::string>> places;
    std::istringstream lines(readBytes(folder / "places"));
    for (std::string line; std::getline(lines, line);) {
        places.push_back(nlohmann::json::parse(line));
    }
    return places;
}

}  // namespace kerf::test
