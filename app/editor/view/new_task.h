#pragma once

#include "app/session/session.h"

namespace kerf {
struct UncutBody;
}

namespace kerf::app {

inline constexpr double kBand = 0.2;    ///< by which a depth may differ, of it
inline constexpr double kInBand = 0.8;  ///< share of a cut that keeps within

/// A task to repeat the cuts of `done`: its lines are where the blade met the skin of the `uncut`
/// body at rest, it goes as deep, and spares the other models. `eye` tells which end of the blade
/// is outside. Otherwise one sentence that says why not. Both relative to the same origin.
std::variant<Task, std::string> taskOfCuts(const Session& done, const UncutBody& uncut,
                                           const Vec3& eye);
/// What to do in a task that was not told otherwise.
std::string aboutOf(const Task& task);
/// What was done before the first stroke, such as pins; a task starts there.
Session beforeCuts(Session done);

}  // namespace kerf::app
