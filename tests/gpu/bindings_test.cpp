// What a pause checks of OpenGL's context.
#include "gpu/bindings.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include "gpu/buffer.h"
#include "tests/support/gl_fixture.h"

namespace kerf::gpu {
namespace {

class BindingsTest : public test::GlTest {};

TEST_F(BindingsTest, NamesWhatOthersTakeForUnbound) {
    EXPECT_EQ(clearBindings(), "");
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    glBindVertexArray(array);
    EXPECT_EQ(clearBindings(), "a vertex array");
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &array);
    Buffer buffer;
    buffer.resize(16);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer.id());
    EXPECT_EQ(clearBindings(), "a buffer of pixels");
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    EXPECT_EQ(clearBindings(), "");
}

TEST_F(BindingsTest, UnbindsWhatEachUserBindsAnew) {
    Buffer buffer;
    buffer.resize(16);
    buffer.bindStorage(3);
    clearBindings();
    GLint bound = -1;
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 3, &bound);
    EXPECT_EQ(bound, 0);
    EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

}  // namespace
}  // namespace kerf::gpu
