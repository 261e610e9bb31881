// Models that are texts, and STL: what other programs write.
#include "app/files/import/import_answer.h"
#include "app/files/io/text_lines.h"
#include "app/import/obj_reader.h"

namespace kerf::app {
namespace {

class TextReaders : public ::testing::Test {
  protected:
    ImportedModel stl(const std::string& bytes) { return readStl(write("a.stl", bytes)); }
    ImportedModel off(const std::string& text) { return readOff(write("a.off", text)); }
    static void expectBox(const ImportedModel& model, const std::string& text) {
        const MeshReport report = inspectTriangles(weldExactly(model.soup));
        EXPECT_TRUE(report.cuttable) << report.problem << "\n" << text;
        EXPECT_NEAR(report.volume, 6, 1e-6) << text;
    }

  private:
    fs::path write(const std::string& name, const std::string& bytes) {
        writeText(folder_ / name, bytes);
        return folder_ / name;
    }
    test::TemporaryFolder folder_;
};

std::string stlText() {
    const TriangleSoup box = boxSoup(Vec3(1, 2, 3));
    std::string text = "solid a box\n";
    for (const Triangle& triangle : box.triangles) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for (const int v : triangle) {
            const Vec3& p = box.positions[v];
            text += "      vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                    std::to_string(p.z()) + "\n";
        }
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid\n";
}

std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

/// With `attribute` at each facet.
std::string stlBytes(const std::string& header, std::uint16_t attribute = 0) {
    const TriangleSoup box = boxSoup(Vec3(1, 2, 3));
    std::string bytes = header;
    bytes.resize(80, ' ');
    const auto append = [&](const auto& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    append(static_cast<std::uint32_t>(box.triangles.size()));
    for (const Triangle& triangle : box.triangles) {
        append(std::array<float, 3>{});
        for (const int v : triangle) {
            append(Vec3f(box.positions[v].cast<float>()));
        }
        append(attribute);
    }
    return bytes;
}

TEST_F(TextReaders, StlIsTheSameHoweverItIsWritten) {
    const std::string text = stlText();
    const std::vector<std::string> variants{
        text,
        upper(text),
        "\xef\xbb\xbf" + text,
        "\n\n" + text,
        "# a comment\n" + text,
        replaced(text, "\n", "\r\n"),
        replaced(text, "\n", "\r"),
        replaced(text, "normal 0 0 0", "normal -1.#IND nan 1.#INF"),
        replaced(text, "endfacet", "endfacet\n; a comment"),
        text + text.substr(0, 12) + "endsolid",
        stlBytes("binary"),
        stlBytes("solid not a text"),
        stlBytes("bytes") + "behind the end"};
    for (const std::string& variant : variants) {
        expectBox(stl(variant), variant.substr(0, 200));
    }
}

TEST_F(TextReaders, StlThatEndsTooEarlyIsRefused) {
    const std::string bytes = stlBytes("binary");
    EXPECT_THAT(inputErrorOf([&] { stl(bytes.substr(0, bytes.size() - 1)); }),
                HasSubstr("neither a binary STL as long as"));
    const std::string text = stlText();
    EXPECT_THAT(inputErrorOf([&] { stl(text.substr(0, text.rfind("endloop"))); }),
                HasSubstr("it ends without \"endsolid\""));
    EXPECT_THAT(inputErrorOf([&] { stl(text.substr(0, text.rfind("  facet"))); }),
                HasSubstr("it ends without \"endsolid\""));
    EXPECT_THAT(inputErrorOf([&] { stl(replaced(text, "-0.500000", "half")); }),
                HasSubstr("line 4: \"half\" stands where a number must"));
    EXPECT_THAT(inputErrorOf([&] { stl("solid\nendsolid\n"); }), HasSubstr("there is no surface"));
}

TEST_F(TextReaders, FacetsOfAnStlMayHaveAColour) {
    EXPECT_TRUE(stl(stlBytes("binary", 7)).soup.skin.colors.empty()) << "a number of a piece";
    const ImportedModel red = stl(stlBytes("VisCAM", 0x8000 | 31 << 10));
    ASSERT_EQ(red.soup.skin.colors.size(), 12U);
    EXPECT_TRUE(red.soup.skin.colors[3][0].isApprox(Eigen::Vector4f(1, 0, 0, 1)));
}

const std::string kOffVertices = "0 0 0\n1 0 0\n0 2 0\n1 2 0\n0 0 3\n1 0 3\n0 2 3\n1 2 3\n";
const std::string kOffFaces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";

TEST_F(TextReaders, OffIsTheSameHoweverItIsWritten) {
    const std::string off = "OFF\n8 6 0\n" + kOffVertices + kOffFaces;
    const std::vector<std::string> variants{
        off,
        "\xef\xbb\xbf" + off,
        "OFF 8 6 12\n" + kOffVertices + kOffFaces,
        "8 6 0\n" + kOffVertices + kOffFaces,
        "OFF\n8\n6\n12 # edges\n" + kOffVertices + kOffFaces,
        "OFF\n8 6\n" + kOffVertices + kOffFaces,
        "# a box\nOFF # of\n\n" + replaced(off.substr(4), "\n", " # comment\n\n"),
        replaced(off, "\n", "\r\n"),
        replaced(off, " ", "\t  "),
        "COFF\n8 6 0\n" + replaced(kOffVertices, "\n", " 255 0 0 255\n") + kOffFaces,
        "NOFF\n8 6 0\n" + replaced(kOffVertices, "\n", " 0 0 1\n") + kOffFaces,
        "4OFF\n8 6 0\n" + replaced(kOffVertices, "\n", " 1\n") + kOffFaces,
        "OFF\n8 6 0\n" + kOffVertices + replaced(kOffFaces, "\n", " 0.5 0.5 1\n")};
    for (const std::string& variant : variants) {
        expectBox(this->off(variant), variant);
    }
}

TEST_F(TextReaders, WhatAnOffCannotBeIsNamed) {
    const auto said = [&](const std::string& text) { return inputErrorOf([&] { off(text); }); };
    EXPECT_THAT(said("OFF BINARY\n"), HasSubstr("it is a binary OFF"));
    EXPECT_THAT(said("nOFF 4\n1 1 0\n"), HasSubstr("other than three dimensions"));
    EXPECT_THAT(said("off\n8 6 0\n"), HasSubstr("begins with neither OFF nor its counts"));
    EXPECT_THAT(said("OFF\n8 7 0\n" + kOffVertices + kOffFaces), HasSubstr("it ends too early"));
    EXPECT_THAT(said("OFF\n8 6 0\n" + replaced(kOffVertices, "3", "x") + kOffFaces),
                HasSubstr("line 7: \"x\" stands where a number must"));
    EXPECT_THAT(said("OFF\n8 1 0\n" + kOffVertices + "3 0 1 8\n"),
                HasSubstr("a face names vertex 8, counted from 0, and there are 8"));
}

TEST_F(TextReaders, ColoursOfAnOffAreOfItsVerticesOrFaces) {
    const auto colored =
        off("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 0 0 1 255\n3 0 1 2\n");
    ASSERT_EQ(colored.soup.skin.colors.size(), 1U);
    EXPECT_TRUE(colored.soup.skin.colors[0][0].isApprox(Eigen::Vector4f(1, 0, 0, 1)));
    EXPECT_TRUE(colored.soup.skin.colors[0][1].isApprox(Eigen::Vector4f(0, 1, 0, 1)));
    const auto faces = off("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0 0 0 255\n");
    ASSERT_EQ(faces.soup.skin.colors.size(), 2U);
    EXPECT_TRUE(faces.soup.skin.colors[0][0].isApprox(Eigen::Vector4f(1, 1, 1, 1)));
    EXPECT_TRUE(faces.soup.skin.colors[1][0].isApprox(Eigen::Vector4f(0, 0, 1, 1)));
}

TEST(TextLines, ABackslashContinuesALineAndNoComment) {
    TextLines lines("f a \\\n b\n# c \\\nd\n\nf e\\");
    std::string all;
    while (lines.next()) {
        all += std::to_string(lines.number()) + ":" + std::string(lines.line()) + "|";
    }
    EXPECT_EQ(all, "1:f a  b|3:# c \\|4:d|5:|6:f e\\|");
}

/// Tests of what reads one format, by texts of a closed box of 1 x 2 x 3.
template <ImportedModel (*Read)(const std::filesystem::path&)>
class BoxReaderTest : public ::testing::Test {
  protected:
    ImportedModel read(const std::string& bytes) {
        test::writeText(folder_ / "a.model", bytes);
        return Read(folder_ / "a.model");
    }
    /// Why the bytes are refused; empty where they are read.
    std::string sentence(const std::string& bytes) {
        return inputErrorOf([&] { read(bytes); });
    }
    /// That the bytes are the box. Returns what was read.
    ImportedModel expectBox(const std::string& bytes) {
        ImportedModel model = read(bytes);
        const MeshReport report = inspectTriangles(model.soup);
        EXPECT_TRUE(report.cuttable) << report.problem << "\n" << bytes;
        EXPECT_EQ(report.triangles, 12) << bytes;
        EXPECT_NEAR(report.volume, 6, 1e-12) << bytes;
        return model;
    }

    test::TemporaryFolder folder_;
};

const std::string kObjVertices =
    "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 1 2 0\nv 0 0 3\nv 1 0 3\nv 0 2 3\nv 1 2 3\n";
const std::string kObjFaces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

class ObjReader : public BoxReaderTest<readObj> {
  protected:
    /// Of the box, read without a remark.
    void expectBox(const std::string& text) {
        EXPECT_THAT(BoxReaderTest::expectBox(text).remarks, IsEmpty()) << text;
    }
};

TEST_F(ObjReader, ABoxIsTheSameHoweverItIsWritten) {
    const std::string box = kObjVertices + kObjFaces;
    expectBox(box);
    expectBox("\xef\xbb\xbf" + box);
    expectBox(replaced(box, "\n", "\r\n"));
    expectBox(replaced(box, "\n", "\r"));
    expectBox(replaced(box, " ", "\t  "));
    expectBox(replaced(box, "f ", "f \\\n  "));
    expectBox("# a path: C:\\\n" + replaced(box, "\n", "\t# a comment \\\n"));
    expectBox("o c:\\x\\\n" + replaced(box, "\n", "# glued\n"));
    expectBox(replaced(box, "v 1 2 3", "v +1. 2.0e0 .3E+1"));
    expectBox(replaced(box, "v 1 2 3", "v 2 4 6 2"));
    expectBox("mg 1 2\no a box\ng side\ns off\nvn 0 0 1\nl 1 2\np 3\n" + box + "f 1 2\n");
    expectBox(kObjFaces + kObjVertices);
    expectBox(box.substr(0, box.size() - 1));
}

TEST_F(ObjReader, CornersCountBackwardsFromWhereTheyStand) {
    std::string faces;
    for (const char* face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"}) {
        faces += "f";
        for (const char* corner = face; *corner != '\0'; corner += corner[1] == '\0' ? 1 : 2) {
            faces += " " + std::to_string(*corner - '0' - 9) + "//-1";
        }
        faces += "\n";
    }
    expectBox(kObjVertices + "vn 0 0 1\n" + faces + "v 7 7 7\n");
}

TEST_F(ObjReader, NumbersAreThoseOfTheTextNearTheOriginAsFloats) {
    const ImportedModel near = read("v 0.1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(near.soup.positions[0].x(), double(0.1F));
    const ImportedModel far =
        read("v 500123.123456 5000456.1 3\nv 500124 5000456 3\nv 500123 5000457 3\nf 1 2 3\n");
    EXPECT_EQ(far.soup.positions[0], Vec3(500123.123456, 5000456.1, 3));
}

TEST_F(ObjReader, WhatIsWrongIsNamedWithItsLine) {
    EXPECT_THAT(sentence("v 0 0\n"), HasSubstr("line 1: a vertex has 2 numbers, and needs three"));
    EXPECT_THAT(sentence("\nv 0 0 1,5\n"), HasSubstr("line 2: \"1,5\" stands where a number must"));
    EXPECT_THAT(sentence(kObjVertices + "f 1 2 x\n"),
                HasSubstr("line 9: \"x\" stands where a corner must"));
    EXPECT_THAT(sentence(kObjVertices + "f 1 2 0\n"), HasSubstr("line 9: \"0\" stands"));
    EXPECT_THAT(sentence(kObjVertices + "f 1 2 -9\n"), HasSubstr("line 9: \"-9\" stands"));
    EXPECT_THAT(sentence(kObjVertices + "f 1 2 9\n"),
                HasSubstr("a face names vertex 8, counted from 0, and there are 8"));
    EXPECT_THAT(sentence("Dear diary\n"), HasSubstr("there is no surface in it"));
    EXPECT_THAT(read(kObjVertices + kObjFaces + "curv 0 1 1 2\nsurf 0 1\n").remarks,
                ElementsAre("Lines that begin with \"curv\", \"surf\" were left out: Kerf does not "
                            "know them."));
}

TEST_F(ObjReader, ColoursOfVerticesAreSharesOrBytes) {
    const std::string text = "v 0 0 0 RED\nv 1 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n";
    for (const char* red : {"1 0 0", "255 0 0"}) {
        const ImportedModel model = read(replaced(text, "RED", red));
        ASSERT_EQ(model.soup.skin.colors.size(), 1U);
        const CornerColors& colors = model.soup.skin.colors[0];
        EXPECT_TRUE(colors[0].isApprox(Eigen::Vector4f(1, 0, 0, 1))) << red;
        EXPECT_TRUE(colors[1].isApprox(Eigen::Vector4f(1, 1, 1, 1))) << "it has none";
        EXPECT_TRUE(colors[2].isApprox(Eigen::Vector4f(0, 0, 0, 1)));
    }
}

TEST_F(ObjReader, MaterialsAreThoseOfTheLibrariesThatItNames) {
    writeText(folder_ / "my paints.mtl", "\xef\xbb\xbfnewmtl red\nKd 1 0 0\nd 0.5\nPm 1\n");
    writeText(folder_ / "b.mtl", "newmtl grey\nKd 0.5\nPr 0.25\nNs 900\nTr 0.25\n");
    const std::string start = "mtllib my paints.mtl\nmtllib b.mtl\n" + kObjVertices;
    const ImportedModel model = read(start + "usemtl grey\nf 1 3 4\nusemtl red\nf 1 4 2\n" +
                                     "usemtl none\nf 5 6 8\nusemtl grey\nf 5 8 7\n");
    EXPECT_THAT(model.soup.skin.materials, ElementsAre(0, 1, -1, 0));
    ASSERT_EQ(model.appearance.materials.size(), 2U);
    const render::SurfaceMaterial& grey = model.appearance.materials[0];
    EXPECT_EQ(grey.name, "grey");
    EXPECT_EQ(grey.baseColor, Eigen::Vector4f(0.5, 0.5, 0.5, 0.75));
    EXPECT_EQ(grey.roughness, 0.25F);
    EXPECT_EQ(model.appearance.materials[1].baseColor, Eigen::Vector4f(1, 0, 0, 0.5));
    EXPECT_EQ(model.appearance.materials[1].metallic, 1);
    EXPECT_THAT(model.remarks, ElementsAre("The material \"none\" was left out: no .mtl file of "
                                           "the model has it."));
}

TEST(ObjMaterials, ImagesStandBehindTheirOptions) {
    const auto imageOf = [](const std::string& line) {
        return readObjMaterials("newmtl a\nmap_Kd " + line + "\n").front();
    };
    EXPECT_EQ(imageOf("my tile.png").image, "my tile.png");
    EXPECT_EQ(imageOf("-clamp on -bm 2 tile.png").image, "tile.png");
    EXPECT_EQ(imageOf("-clamp on -bm 2 tile.png").leftOut, "");
    EXPECT_EQ(imageOf("-s 2 2 1 -o 0.5 3d tile.png").image, "3d tile.png");
    EXPECT_EQ(imageOf("-s 2 tile.png").leftOut, "-s");
}

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
    expectBox(kPly + "element none 99999999999999\n" + kVertex + kFace + kEnd + kVertices + kFaces);
    const std::string plain = kPly + kVertex + kFace + kEnd + kVertices + kFaces;
    for (const char* end : {"\r\n", "\r", " \n", "\t\r\n"}) {
        expectBox(replaced(plain, "\n", end));
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
