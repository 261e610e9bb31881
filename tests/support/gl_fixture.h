#pragma once

#include <gtest/gtest.h>

namespace kerf::test {

/// Base of every test that draws or computes with OpenGL. All tests of a binary share one headless
/// context with debug output on; an OpenGL error that a test leaves behind fails it.
class GlTest : public ::testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;
};

}  // namespace kerf::test
