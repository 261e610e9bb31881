#pragma once

#include <algorithm>
#include <vector>

namespace kerf {

/// Ascending, each once.
template <class Value>
void sortUnique(std::vector<Value>& values) {
    if (!std::is_sorted(values.begin(), values.end())) {
        std::sort(values.begin(), values.end());
    }
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace kerf
