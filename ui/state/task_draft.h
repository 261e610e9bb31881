#pragma once

#include <string>
#include <vector>

namespace kerf::ui {

/// What a teacher sets of a task that is being made.
struct TaskDraft {
    /// A model that is not cut.
    struct Spared {
        std::string name;
        int model = 0;
        bool spared = true;
    };
    std::string name;
    std::string about;
    double depth = 0;      ///< [m]; 0 right through
    double deviation = 0;  ///< from the line, at most [m]
    double seconds = 0;    ///< at most; 0 as long as it takes
    double longest = 1;    ///< of the lengths [m]
    std::vector<Spared> models;
};

}  // namespace kerf::ui
