#pragma once

#include <string>

namespace kerf::app {

/// The JSON Schema (draft 7) of session files, by which text editors complete and check them: made
/// from the tables of the reader. It accepts every session that parseSession() accepts. It can't
/// tell what compares values, such as the order of two corners, nor what is wrong with the text as
/// JSON, such as a key that stands there twice.
std::string sessionSchema();
/// The JSON Schema (draft 7) of material files, made from the table of the reader.
std::string materialSchema();
/// The text of docs/NAME, which is written anew as `text` where $KERF_RENEW is set.
std::string schemaFile(const std::string& name, const std::string& text);

}  // namespace kerf::app
