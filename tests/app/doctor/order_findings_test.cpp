// Faults that drivers have had, or may have, stand between Kerf and OpenGL: kerf doctor must find
// each.
#include <glad/gl.h>
#include <gmock/gmock.h>

#include "app/doctor/findings.h"
#include "tests/app/doctor/wrong_findings.h"
#include "tests/support/gl_fixture.h"

namespace kerf::app {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// What a fault stands before.
struct Functions {
    PFNGLNAMEDBUFFERSUBDATAPROC subData = glad_glNamedBufferSubData;
    PFNGLCOPYNAMEDBUFFERSUBDATAPROC copy = glad_glCopyNamedBufferSubData;
    PFNGLCLEARNAMEDBUFFERSUBDATAPROC clear = glad_glClearNamedBufferSubData;
    PFNGLGETNAMEDBUFFERSUBDATAPROC get = glad_glGetNamedBufferSubData;
    PFNGLDISPATCHCOMPUTEPROC dispatch = glad_glDispatchCompute;
    PFNGLMEMORYBARRIERPROC barrier = glad_glMemoryBarrier;
    PFNGLGETINTEGERI_VPROC limit = glad_glGetIntegeri_v;
};
Functions driver;
std::function<void()> late;  // a command whose effect comes after that of the next one

void comeLate() {
    if (late) {
        std::exchange(late, nullptr)();
    }
}

class OrderFindings : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        driver = Functions();
        glad_glCopyNamedBufferSubData = [](auto... all) {
            comeLate();
            driver.copy(all...);
        };
        glad_glGetNamedBufferSubData = [](auto... all) {
            comeLate();
            driver.get(all...);
        };
    }
    void TearDown() override {
        comeLate();
        glad_glNamedBufferSubData = driver.subData;
        glad_glCopyNamedBufferSubData = driver.copy;
        glad_glClearNamedBufferSubData = driver.clear;
        glad_glGetNamedBufferSubData = driver.get;
        glad_glDispatchCompute = driver.dispatch;
        glad_glMemoryBarrier = driver.barrier;
        glad_glGetIntegeri_v = driver.limit;
        GlTest::TearDown();
    }
    static std::vector<std::string> wrong() { return wrongOnes(orderFindings({4, 4096})); }
};

TEST_F(OrderFindings, AreRightHere) {
    EXPECT_THAT(wrong(), IsEmpty());
    EXPECT_THAT(wrongOnes(formFindings()), IsEmpty());
}

// As NVIDIA's 580.159 did (docs/notes/drivers.md).
TEST_F(OrderFindings, TellOfAClearThatComesAfterTheNextWrite) {
    glad_glClearNamedBufferSubData = [](GLuint buffer, GLenum format, GLintptr first,
                                        GLsizeiptr bytes, GLenum words, GLenum type,
                                        const void* data) {
        comeLate();
        GLint mapped = 0;
        glGetNamedBufferParameteriv(buffer, GL_BUFFER_MAPPED, &mapped);
        if (mapped != 0) {  // the mark of a ReadBack, which would wait for it
            driver.clear(buffer, format, first, bytes, words, type, data);
            return;
        }
        late = [=, value = *static_cast<const std::uint32_t*>(data)] {
            if (glIsBuffer(buffer) == GL_TRUE) {
                driver.clear(buffer, format, first, bytes, words, type, &value);
            }
        };
    };
    glad_glNamedBufferSubData = [](auto... all) {
        driver.subData(all...);
        comeLate();
    };
    glad_glDispatchCompute = [](auto... all) {
        driver.dispatch(all...);
        comeLate();
    };
    const std::vector<std::string> found = wrong();
    for (const char* write : {"A write by glNamedBufferSubData()", "A write by a kernel"}) {
        for (const char* format : {"GL_R8UI", "GL_R32UI"}) {
            EXPECT_THAT(found, Contains(AllOf(HasSubstr(write), HasSubstr("after a clear"),
                                              HasSubstr(format), HasSubstr("lost"),
                                              HasSubstr("4 bytes and 4 KB"))));
        }
    }
    // As docs/gpus.md has it.
    EXPECT_THAT(found,
                Contains("A write by glNamedBufferSubData() after a clear by "
                         "glClearNamedBufferSubData(GL_R8UI): lost in buffers of 4 bytes and 4 KB, "
                         "as seen by a kernel, a uniform block, an indirect dispatch, "
                         "glGetNamedBufferSubData(), mapped memory and texels, asked what was "
                         "written last"));
    EXPECT_THAT(found, Not(Contains(HasSubstr("after a copy"))));
}

TEST_F(OrderFindings, TellOfAWriteThatTheNextKernelDoesNotSee) {
    glad_glNamedBufferSubData = [](GLuint buffer, GLintptr first, GLsizeiptr bytes,
                                   const void* data) {
        comeLate();
        const auto* const from = static_cast<const std::byte*>(data);
        late = [=, copy = std::vector<std::byte>(from, from + bytes)] {
            if (glIsBuffer(buffer) == GL_TRUE) {
                driver.subData(buffer, first, bytes, copy.data());
            }
        };
    };
    glad_glDispatchCompute = [](auto... all) {
        driver.dispatch(all...);
        comeLate();
    };
    EXPECT_THAT(wrong(), Contains(AllOf(HasSubstr("glNamedBufferSubData()"), HasSubstr("lost"),
                                        HasSubstr("a kernel"))));
}

GLbitfield ignoredBarriers = 0;
GLbitfield passedBarriers = 0;  // since the last kernel

/// A kernel's writes come with the next command that no barrier lets wait.
void writeKernelsLate() {
    glad_glDispatchCompute = [](auto... all) {
        comeLate();
        driver.dispatch(all...);
        passedBarriers = 0;
        late = [=] { driver.dispatch(all...); };
    };
    glad_glMemoryBarrier = [](GLbitfield bits) {
        driver.barrier(bits);
        passedBarriers |= bits & ~ignoredBarriers;
        if ((passedBarriers & GL_BUFFER_UPDATE_BARRIER_BIT) != 0) {
            comeLate();
        }
    };
    glad_glNamedBufferSubData = [](auto... all) {
        driver.subData(all...);
        comeLate();
    };
    glad_glClearNamedBufferSubData = [](auto... all) {
        driver.clear(all...);
        comeLate();
    };
}

TEST_F(OrderFindings, HaveTheBarriersThatADriverMayAskFor) {
    ignoredBarriers = 0;
    writeKernelsLate();
    EXPECT_THAT(wrong(), IsEmpty());
}

TEST_F(OrderFindings, TellOfABarrierThatDoesNotWork) {
    ignoredBarriers = GL_BUFFER_UPDATE_BARRIER_BIT;
    writeKernelsLate();
    const std::vector<std::string> found = wrong();
    for (const char* write : {"A write by glNamedBufferSubData()", "A clear by"}) {
        EXPECT_THAT(found, Contains(AllOf(HasSubstr(write), HasSubstr("after a write by a kernel"),
                                          HasSubstr("lost"))));
    }
}

TEST_F(OrderFindings, TellOfWorkGroupsThatAreLeftOut) {
    glad_glGetIntegeri_v = [](GLenum name, GLuint index, GLint* value) {
        driver.limit(name, index, value);
        *value = name == GL_MAX_COMPUTE_WORK_GROUP_COUNT ? 1 << 20 : *value;
    };
    glad_glDispatchCompute = [](GLuint x, GLuint y, GLuint z) {
        driver.dispatch(x & 0xffff, y, z);
    };
    EXPECT_THAT(wrongOnes(formFindings()), Contains("Work groups at once: 4464, asked 70000"));
}

}  // namespace
}  // namespace kerf::app
