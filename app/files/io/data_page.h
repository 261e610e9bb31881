#pragma once

#include <nlohmann/json_fwd.hpp>

namespace kerf::app {

/// A page of assets/report with `data` in place of the JSON of its script "data". Throws InputError
/// if the page can't be read.
std::string dataPage(const std::string& asset, const nlohmann::ordered_json& data);

}  // namespace kerf::app
