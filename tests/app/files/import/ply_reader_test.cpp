#include <gmock/gmock.h>

#include <cstring>

#include "app/files/import/face_soup.h"
#include "tests/app/files/import/box_reader_test.h"
#include "tests/support/replaced_text.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using test::replaced;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kPly = "ply\nformat ascii 1.0\n";
const std::string kVertex =
    "element vertex 8\nproperty double x\nproperty float32 y\nproperty int z\n";
const std::string kFace = "element face 6\nproperty list uint8 int32 vertex_index\n";
const std::string kEnd = "end_header\n";
const std::string kVertices = "0 0 0\n1 0 0\n0 2 0\n1 2 0\n0 0 3\n1 0 3\n0 2 3\n1 2 3\n";
const std::string kFaces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";

using PlyReader = BoxReaderTest<readPly>;

/// The box in binary, with a property of one byte before each position.
std::string binaryBox(bool bigEndian, const std::string& lineEnd, char before) {
    std::string bytes = "ply\nformat binary_" + std::string(bigEndian ? "big" : "little") +
                        "_endian 1.0\ncomment end_header\nelement vertex 8\nproperty uchar kind\n"
                        "property float x\nproperty double y\nproperty short z\n" +
                        kFace + kEnd;
    bytes = replaced(bytes, "\n", lineEnd);
    const auto append = [&](auto value) {
        char raw[sizeof(value)];
        std::memcpy(raw, &value, sizeof(value));
        if (bigEndian) {
            std::reverse(raw, raw + sizeof(value));
        }
        bytes.append(raw, sizeof(value));
    };
    for (int v = 0; v < 8; ++v) {
        append(before);
        append(static_cast<float>(v % 2));
        append(2.0 * (v / 2 % 2));
        append(static_cast<std::int16_t>(v / 4 * 3));
    }
    for (const auto& quad : {std::array{0, 2, 3, 1},
                             {4, 5, 7, 6},
                             {0, 1, 5, 4},
                             {2, 6, 7, 3},
                             {0, 4, 6, 2},
                             {1, 3, 7, 5}}) {
        append(static_cast<std::uint8_t>(4));
        for (const std::int32_t corner : quad) {
            append(corner);
        }
    }
    return bytes;
}

TEST_F(PlyReader, ElementsComeInAnyOrderWithCommentsAndAByteOrderMark) {
    expectBox(kPly + kVertex + kFace + kEnd + kVertices + kFaces);
    expectBox("\xef\xbb\xbf" + kPly + kFace + "comment between\nobj_info a\n" + kVertex + kEnd +
              kFaces + kVertices);
    expectBox("ply\ncomment before\nformat ascii 1.0\nelement none 0\n" + kVertex + kFace + kEnd +
              replaced(kVertices, "1", "+1e0") + replaced(kFaces, " ", "  "));
}

TEST_F(PlyReader, LinesEndInAnyWay) {
    const std::string text = kPly + kVertex + kFace + kEnd + kVertices + kFaces;
    for (const char* end : {"\r\n", "\r", " \n", "\t\r\n"}) {
        expectBox(replaced(text, "\n", end));
    }
}

TEST_F(PlyReader, DataMayBeginWithAnyByte) {
    for (const bool bigEndian : {false, true}) {
        for (const std::string lineEnd : {"\n", "\r\n", "\r"}) {
            for (const char before : {'\0', '\t', '\n', '\r', ' ', 'e', '\x7f'}) {
                SCOPED_TRACE(testing::PrintToString(lineEnd) + " " + std::to_string(before));
                expectBox(binaryBox(bigEndian, lineEnd, before));
            }
        }
    }
}

TEST_F(PlyReader, StripsTurnEveryOtherTriangleAndBeginAnew) {
    expectBox(kPly + kVertex + "element tristrips 1\nproperty list int int vertex_indices\n" +
              kEnd + kVertices +
              "29 0 2 1 3 -1 4 5 6 7 -1 0 1 4 5 -1 2 6 3 7 -1 0 4 2 6 -1 1 3 5 7\n");
}

TEST_F(PlyReader, DoublesKeepTheirBits) {
    const ImportedModel model =
        read(kPly + kVertex + kFace + kEnd + replaced(kVertices, "1 0 0", "500000.1234567891 0 0") +
             kFaces);
    EXPECT_EQ(model.soup.positions[1].x(), 500000.1234567891);
}

TEST_F(PlyReader, ANumberTooLargeForADoubleIsNotZero) {
    const std::string head = kPly + kVertex + kFace + kEnd;
    const ImportedModel model = read(head + replaced(kVertices, "2", "-1e400") + kFaces);
    EXPECT_EQ(model.soup.positions[2].y(), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(
        read(head + replaced(kVertices, "0 0 0", "1e-400 0 0") + kFaces).soup.positions[0].x(), 0);
}

TEST_F(PlyReader, AnElementWithoutPropertiesHoldsNothing) {
    expectBox(kPly + "element none 99999999999999\n" + kVertex + kFace + kEnd + kVertices + kFaces);
}

TEST_F(PlyReader, ColorsAreOfVerticesOrFacesAndCountAsTheirTypeSays) {
    const std::string colors = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    const ImportedModel byVertex = read(kPly + kVertex + colors + kFace + kEnd +
                                        replaced(kVertices, "\n", " 255 0 51\n") + kFaces);
    ASSERT_EQ(byVertex.soup.skin.colors.size(), 12U);
    EXPECT_TRUE(byVertex.soup.skin.colors[5][1].isApprox(Eigen::Vector4f(1, 0, 0.0331F, 1), 1e-3F));
    const ImportedModel byFace = read(kPly + kVertex + kFace + replaced(colors, "uchar", "float") +
                                      kEnd + kVertices + replaced(kFaces, "\n", " 1 0 0.2\n"));
    ASSERT_EQ(byFace.soup.skin.colors.size(), 12U);
    EXPECT_EQ(byFace.soup.skin.colors[5][1], byVertex.soup.skin.colors[5][1]);
}

TEST_F(PlyReader, TextureCoordinatesAreOfVerticesOrCornersAndTheImageIsNamed) {
    const ImportedModel byVertex = read(kPly + "comment TextureFile a b.png\n" + kVertex +
                                        "property float s\nproperty float t\n" + kFace + kEnd +
                                        replaced(kVertices, "\n", " 0.25 0.75\n") + kFaces);
    ASSERT_EQ(byVertex.soup.skin.uvs.size(), 12U);
    EXPECT_EQ(byVertex.soup.skin.uvs[3][2], Eigen::Vector2f(0.25F, 0.75F));
    EXPECT_THAT(byVertex.remarks, ElementsAre(HasSubstr("The image \"a b.png\"")));
    const ImportedModel byCorner =
        read(kPly + kVertex + kFace + "property list uchar float texcoord\n" + kEnd + kVertices +
             replaced(kFaces, "\n", " 8 0 0 0 1 1 1 1 0\n"));
    ASSERT_EQ(byCorner.soup.skin.uvs.size(), 12U);
    EXPECT_NE(byCorner.soup.skin.uvs[0][0], byCorner.soup.skin.uvs[0][1]);
    EXPECT_THAT(byCorner.remarks, IsEmpty());
}

TEST_F(PlyReader, AnElementThatIsNotKnownIsNamed) {
    const ImportedModel model =
        read(kPly + "element camera 2\nproperty float a\nproperty list uchar int b\n" + kVertex +
             kFace + kEnd + "1 2 3 4\n0.5 0\n" + kVertices + kFaces);
    EXPECT_THAT(model.remarks, ElementsAre(HasSubstr("\"camera\" was left out")));
    EXPECT_EQ(model.soup.triangles.size(), 12U);
}

TEST_F(PlyReader, WhatIsMissingIsTold) {
    const std::string head = kPly + kVertex + kFace + kEnd;
    EXPECT_THAT(sentence("Dear diary\n"), HasSubstr("does not begin with a line \"ply\""));
    EXPECT_THAT(sentence(kPly + kVertex), HasSubstr("no line \"end_header\""));
    EXPECT_THAT(sentence(replaced(head, "ascii", "utf8")), HasSubstr("\"utf8\""));
    EXPECT_THAT(sentence(replaced(head, "double", "real")), HasSubstr("\"real\""));
    EXPECT_THAT(sentence(replaced(head, "vertex 8", "vertex many")), HasSubstr("without a count"));
    EXPECT_THAT(sentence(head + kVertices + kFaces.substr(0, 28)),
                HasSubstr("\"face\": 2 of 6 are there"));
    const auto withWord = [&](const char* word) {
        return head + replaced(kVertices, "2", word) + kFaces;
    };
    for (const char* word : {"two", "1,5", "2.0x", "+", "-"}) {
        EXPECT_THAT(sentence(withWord(word)),
                    HasSubstr("\"" + std::string(word) + "\" stands where a number must"));
    }
    EXPECT_THAT(sentence(kPly + kVertex + kVertex + kFace + kEnd), HasSubstr("\"vertex\" twice"));
    EXPECT_THAT(sentence(replaced(head, " z", " depth") + kVertices + kFaces),
                HasSubstr("no x, y and z"));
    EXPECT_THAT(sentence(kPly + kVertex + kEnd + kVertices), HasSubstr("no surface"));
    const std::string binary = binaryBox(false, "\n", 0);
    EXPECT_THAT(sentence(binary.substr(0, binary.size() - 1)), HasSubstr("5 of 6 are there"));
}

}  // namespace
}  // namespace kerf::app
