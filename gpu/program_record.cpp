#include "gpu/program_record.h"

namespace kerf::gpu {
namespace {

ProgramRecord*& noting() {
    static ProgramRecord* record = nullptr;
    return record;
}

}  // namespace

ProgramRecord::ProgramRecord() : before_(noting()) {
    noting() = this;
}

ProgramRecord::~ProgramRecord() {
    noting() = before_;
}

ProgramRecord* ProgramRecord::current() {
    return noting();
}

}  // namespace kerf::gpu
