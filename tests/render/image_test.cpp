#include "render/scene/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/temporary_folder.h"
#include "tests/support/written_png.h"

namespace kerf::render {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Image gradient(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int channel : {x * 7, y * 11, x * y, 255 - x}) {
                image.pixels.push_back(static_cast<std::uint8_t>(channel));
            }
        }
    }
    return image;
}

std::string readError(const fs::path& file) {
    try {
        readPng(file);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

using test::readBytes;
using test::writeText;

class ImageFile : public testing::Test {
  protected:
    test::TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "picture.png";
};

TEST_F(ImageFile, ComesBackAsWritten) {
    const Image image = gradient(33, 17);
    test::writePng(image, file_);
    const Image back = readPng(file_);
    EXPECT_EQ(back.width, 33);
    EXPECT_EQ(back.height, 17);
    EXPECT_EQ(back.pixels, image.pixels);
}

TEST_F(ImageFile, EqualPicturesGiveEqualBytes) {
    test::writePng(gradient(20, 20), file_);
    const std::string first = readBytes(file_);
    test::writePng(gradient(20, 20), file_);
    EXPECT_EQ(readBytes(file_), first);
}

TEST_F(ImageFile, MissingFileIsNamed) {
    EXPECT_THAT(readError(file_), HasSubstr(file_.string()));
    EXPECT_THAT(readError(file_), HasSubstr("no such file"));
}

TEST_F(ImageFile, TextIsNotAPng) {
    writeText(file_, "not a picture");
    EXPECT_THAT(readError(file_), HasSubstr("not a PNG"));
}

TEST_F(ImageFile, FolderIsRefused) {
    EXPECT_THAT(readError(folder_.path()), HasSubstr("not a regular file"));
}

TEST_F(ImageFile, CutOffFileIsDamaged) {
    test::writePng(gradient(64, 64), file_);
    const std::string bytes = readBytes(file_);
    writeText(file_, bytes.substr(0, bytes.size() / 2));
    EXPECT_THAT(readError(file_), HasSubstr("damaged"));
    writeText(file_, bytes.substr(0, 12));
    EXPECT_THAT(readError(file_), HasSubstr("damaged"));
}

}  // namespace
}  // namespace kerf::render
