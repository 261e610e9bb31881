#pragma once

namespace kerf::app {

/// The JSON Schema (draft 7) of session files for text editors, made from the tables of the reader.
/// It accepts every session that parseSession() accepts. It can't compare values, such as the order
/// of two corners, or find errors of the JSON text, such as duplicate keys.
std::string sessionSchema();
/// The JSON Schema (draft 7) of material files, made from the table of the reader.
std::string materialSchema();
/// The text of docs/NAME, which is written anew as `text` where $KERF_RENEW is set.
std::string schemaFile(const std::string& name, const std::string& text);

}  // namespace kerf::app
