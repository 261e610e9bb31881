#include "app/files/jobs/interruption.h"

namespace kerf::app {

namespace {

volatile std::sig_atomic_t interrupted = 0;

void noteSignal(int /*signal*/) {
    interrupted = 1;
}

}  // namespace

Interruption::Interruption() {
    interrupted = 0;
    struct sigaction note {};
    note.sa_handler = noteSignal;
    note.sa_flags = SA_RESTART;
    ::sigaction(SIGINT, &note, &earlierInterrupt_);
    ::sigaction(SIGTERM, &note, &earlierTerminate_);
}

Interruption::~Interruption() {
    ::sigaction(SIGINT, &earlierInterrupt_, nullptr);
    ::sigaction(SIGTERM, &earlierTerminate_, nullptr);
}

bool Interruption::requested() {
    return interrupted != 0;
}

}  // namespace kerf::app
