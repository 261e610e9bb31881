#pragma once

#include <pugixml.hpp>

namespace kerf::app {

/// Reads XML in any encoding that it names, UTF-16 too; texts without blanks around them. Throws
/// InputError with the line.
void loadXml(std::string_view bytes, pugi::xml_document& document);

}  // namespace kerf::app
