// kerf-import FILE ORDER...: reads and mends a model for Kerf, which starts it. A program of its
// own, so that a damaged file ends nothing else, and since CGAL's union of meshes is under the GPL:
// so is this program once it is linked.
#include <exception>
#include <iostream>

#include "app/import/model_answer.h"

int main(int count, char** words) {
    if (count < 3) {
        std::cerr << "kerf-import: Kerf starts this program to read models; use kerf inspect "
                     "MODEL.\n";
        return 2;
    }
    try {
        return kerf::app::runImport(words[1], {words + 2, words + count});
    } catch (const std::exception& error) {
        std::cerr << "kerf-import: " << error.what() << '\n';
        return 1;
    }
}
