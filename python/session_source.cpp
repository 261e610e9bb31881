#include "python/session_source.h"

#include <spdlog/spdlog.h>

#include "app/session/material.h"

namespace kerf::python {

app::Session readSource(const SessionSource& source) {
    app::Session session = source.file.empty()
                               ? app::parseSession(source.text, std::filesystem::current_path())
                               : app::readSession(source.file);
    if (!source.material.empty()) {
        app::applyMaterial(session, app::findMaterial(source.material, {}));
    }
    for (const auto& [name, value] : source.params) {
        app::setParamFromText(session.params, name, value);
    }
    app::requireModelsOfParams(session);
    for (const std::string& warning : session.warnings) {
        spdlog::warn(warning);
    }
    return session;
}

}  // namespace kerf::python
