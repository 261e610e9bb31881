#include "gpu/context.h"

#include <glad/gl.h>

#include <cstdlib>

#include "gpu/traffic.h"
#include "tests/support/gl_fixture.h"

namespace kerf::gpu {
namespace {

class Context : public test::GlTest {};

TEST_F(Context, IsOpenGl45Core) {
    GLint major = 0;
    GLint minor = 0;
    GLint profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(major * 10 + minor, 45);
    EXPECT_EQ(profile & GL_CONTEXT_CORE_PROFILE_BIT, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST_F(Context, DescribesItsDevice) {
    const DeviceInfo info = queryDevice();
    EXPECT_FALSE(info.vendor.empty());
    EXPECT_FALSE(info.version.empty());
    EXPECT_GE(info.maxSamples, 4);
    EXPECT_EQ(info.software, info.renderer.find("llvmpipe") != std::string::npos);
}

TEST_F(Context, AsksForRobustAccess) {
    if (!queryDevice().software) {
        GTEST_SKIP() << "this driver may not offer it";
    }
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    EXPECT_EQ(flags & GL_CONTEXT_FLAG_ROBUST_ACCESS_BIT, GL_CONTEXT_FLAG_ROBUST_ACCESS_BIT);
}

TEST_F(Context, CountsTheErrorsOfTheDriver) {
    glEnable(GL_TEXTURE_2D);  // not a capability of the core profile
    EXPECT_EQ(takeDebugErrors(), 1);
    EXPECT_EQ(takeDebugErrors(), 0);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
}

TEST_F(Context, WhatAnotherMadeVisibleIsNotVisibleHere) {
    const auto barriers = [] {
        const std::uint64_t before = traffic().barriers;
        updateBarrier();
        return traffic().barriers - before;
    };
    barriers();
    EXPECT_EQ(barriers(), 0U) << "no kernel ran";
    EglContext second;
    EXPECT_EQ(barriers(), 1U);
    GlTest::SetUp();
    EXPECT_EQ(barriers(), 1U);
}

TEST_F(Context, SecondOneLeavesTheFirstUsable) {
    GLuint buffer = 0;
    glCreateBuffers(1, &buffer);
    {
        const EglContext second;
        EXPECT_EQ(glIsBuffer(buffer), GL_FALSE) << "contexts share nothing";
    }
    GlTest::SetUp();
    EXPECT_EQ(glIsBuffer(buffer), GL_TRUE);
    glDeleteBuffers(1, &buffer);
}

TEST(ContextFailure, SaysThatItIsSwitchedOff) {
    setenv("KERF_FORCE_NO_GL", "1", 1);
    try {
        const EglContext context;
        FAIL() << "made a context";
    } catch (const ContextError& error) {
        EXPECT_STREQ(error.what(),
                     "No OpenGL 4.5 context: it is switched off by KERF_FORCE_NO_GL; unset that "
                     "variable.");
    }
    unsetenv("KERF_FORCE_NO_GL");
}

TEST(ContextFailure, LoadingWithoutAContextIsRefused) {
    EXPECT_THROW(loadFunctions([](const char*) -> void (*)() { return nullptr; }), ContextError);
    const EglContext loadsThemAgain;
}

}  // namespace
}  // namespace kerf::gpu
