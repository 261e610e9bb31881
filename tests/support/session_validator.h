#pragma once

namespace kerf::test {

/// Whether the validator is installed: Debian's python3-jsonschema.
bool hasSchemaValidator();

/// What a validator of JSON Schema finds wrong in each of these JSON texts by the schema of
/// sessions: places such as "events[0].a", none where the text is valid. Throws where the schema is
/// none, or a text no JSON.
std::vector<std::vector<std::string>> placesWrongBySchema(const std::vector<std::string>& texts);

}  // namespace kerf::test
