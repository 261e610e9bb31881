#include "sim/solve/saved_pieces.h"

#include <cassert>
#include <vector>

#include "shaders/shared/bindings.h"

namespace kerf {

SavedPieces::SavedPieces(SolverBody& body)
    : body_(body), kernel_(gpu::Program::compute("sim/restore.comp")) {}

void SavedPieces::restoreAtRest(std::span<const int> pieces) {
    assert(body_.state.saved.size() == body_.state.positions.size());
    std::vector<shared::uint> marks(body_.pieces.pieces().size(), 0);
    for (const int piece : pieces) {
        marks[piece] = 1;
    }
    marks_.assign(marks);
    body_.bind();
    body_.state.saved.bindStorage(shared::kSavedBinding);
    marks_.bindStorage(shared::kMarksBinding);
    body_.run(kernel_, body_.uniforms.vertex_count);
}

}  // namespace kerf
