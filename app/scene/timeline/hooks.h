#pragma once

#include "sim/run/parts/hands.h"

namespace kerf::app {

/// Hands from this number on are hooks, which stay when released. Two are a retractor: an even
/// number, and the next one.
inline constexpr int kFirstHook = 50;
inline constexpr int kLastHook = 99;

constexpr bool isHook(int hand) {
    return hand >= kFirstHook;
}
/// The other hook of its retractor.
constexpr int partnerOf(int hook) {
    return hook ^ 1;
}

/// The hooks among the hands, by number.
std::vector<Hands::Hand> hooksOf(const std::vector<Hands::Hand>& hands);
/// The first hook of an unused retractor; none if all are in use.
std::optional<int> freeRetractor(const std::vector<Hands::Hand>& hands);

}  // namespace kerf::app
