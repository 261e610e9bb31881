// A saved session ends in the bits that it was saved with.
#pragma once

#include <gmock/gmock.h>

#include "app/cli/replay/replay.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {

/// The check with which the editor ends a session.
inline CheckEvent lastCheck(const Session& session) {
    return std::get<CheckEvent>(session.events.back().action);
}

/// Replays it without the editor, where no check may fail. Returns the state hash at its end.
inline std::string replayedHash(const Session& session, const ModelMesh& model) {
    const test::TemporaryFolder out;
    const ReplayResult result = replaySession(session, model, out.path(), {});
    EXPECT_THAT(result.summary.failures, ::testing::IsEmpty());
    return result.summary.stateHash;
}

/// Replays it without the editor: no check on the way fails, and the last one holds.
inline void expectReplayed(const Session& session, const ModelMesh& model) {
    EXPECT_EQ(replayedHash(session, model), lastCheck(session).hash);
}

}  // namespace kerf::app
