#include "app/cli/cli.h"

int main(int argc, char** argv) {
    return kerf::app::runCommandLine(argc, argv);
}
