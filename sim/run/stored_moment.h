#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/run/moment.h"

namespace kerf {

/// A moment as bytes, without its undo history, from which Simulation::goTo() continues bit for
/// bit: in another process, too, of the same program and with the same models. Nothing while a
/// blade is placed. On any thread.
std::optional<std::vector<std::byte>> bytesOf(const Moment& moment);

}  // namespace kerf
