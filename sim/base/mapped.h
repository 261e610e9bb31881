#pragma once

#include <functional>
#include <type_traits>
#include <vector>

namespace kerf {

/// What `f`, a function or a member, gives for each item, in their order.
template <class Items, class F>
auto mapped(const Items& items, F f) {
    std::vector<std::decay_t<decltype(std::invoke(f, *items.begin()))>> results;
    results.reserve(items.size());
    for (const auto& item : items) {
        results.push_back(std::invoke(f, item));
    }
    return results;
}

}  // namespace kerf
