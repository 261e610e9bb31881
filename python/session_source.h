#pragma once

#include "app/session/session.h"

namespace kerf::python {

/// A session as given from Python.
struct SessionSource {
    std::string file;      ///< path of a file, or
    std::string text;      ///< the text of one, with paths relative to the working folder
    std::string material;  ///< a name or a file instead of the session's; empty for none
    std::vector<std::pair<std::string, std::string>> params;  ///< name, value as JSON; at the start
};

/// Reads it; harmless but meaningless input is logged. Throws InputError.
app::Session readSource(const SessionSource& source);

}  // namespace kerf::python
