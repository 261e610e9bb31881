#pragma once

#include "app/practice/score.h"

namespace kerf::app {

/// What to do next time, in one or two sentences, by the limits that a try broke; "" if it passed.
std::string adviceOn(const Score& score, const Task& task);

}  // namespace kerf::app
