#pragma once

#include <string>
#include <utility>
#include <vector>

namespace kerf::gpu {

/// A shader as a driver compiled it, on its way into a program.
struct LinkedStage {
    std::string file;  ///< below shaderRoot(): "sim/floor.comp"
    std::string text;  ///< with all that it includes, definitions in front
};

/// A program that was linked.
struct LinkedProgram {
    std::vector<std::pair<std::string, std::string>> defines;  ///< name and value
    std::vector<LinkedStage> stages;
};

/// While it lives, notes each program that is linked, also those that come from the cache; not
/// those that a ProgramShelf gives again. Of several, the one made last notes.
class ProgramRecord {
  public:
    ProgramRecord();
    ~ProgramRecord();
    ProgramRecord(const ProgramRecord&) = delete;
    ProgramRecord& operator=(const ProgramRecord&) = delete;

    const std::vector<LinkedProgram>& programs() const { return programs_; }

    /// The record that notes now; null for none.
    static ProgramRecord* current();
    void note(LinkedProgram program) { programs_.push_back(std::move(program)); }

  private:
    ProgramRecord* before_;
    std::vector<LinkedProgram> programs_;
};

}  // namespace kerf::gpu
