#include "tests/support/gl_fixture.h"

#include <cstdlib>

#include "gpu/context.h"

namespace kerf::test {
namespace {

/// Ends the context before the process's static objects go, on which the drivers depend.
class ContextEnvironment : public ::testing::Environment {
  public:
    void makeCurrent() {
        if (!context_) {
            setenv("KERF_GL_DEBUG", "1", 1);
            context_ = std::make_unique<gpu::EglContext>();
        }
        context_->makeCurrent();
    }
    void TearDown() override { context_.reset(); }

  private:
    std::unique_ptr<gpu::EglContext> context_;
};

// GoogleTest owns it.
auto* const kSharedContext =
    static_cast<ContextEnvironment*>(::testing::AddGlobalTestEnvironment(new ContextEnvironment));

}  // namespace

void GlTest::SetUp() {
    kSharedContext->makeCurrent();
    gpu::takeDebugErrors();
}

void GlTest::TearDown() {
    EXPECT_EQ(gpu::takeDebugErrors(), 0) << "OpenGL errors, see the log above";
}

}  // namespace kerf::test
