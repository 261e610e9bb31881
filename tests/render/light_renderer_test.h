#pragma once

#include "render/renderer.h"
#include "tests/support/gl_fixture.h"

namespace kerf::render {

/// Tests that draw on the light tier.
class LightRendererTest : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        renderer_ = std::make_unique<Renderer>(Quality::light);
    }
    void TearDown() override {
        renderer_.reset();
        GlTest::TearDown();
    }

    std::unique_ptr<Renderer> renderer_;
};

}  // namespace kerf::render
