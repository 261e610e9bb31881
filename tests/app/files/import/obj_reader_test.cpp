#include "app/files/import/obj_reader.h"

#include <gmock/gmock.h>

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
    test::writeText(folder_ / "my paints.mtl", "\xef\xbb\xbfnewmtl red\nKd 1 0 0\nd 0.5\nPm 1\n");
    test::writeText(folder_ / "b.mtl", "newmtl grey\nKd 0.5\nPr 0.25\nNs 900\nTr 0.25\n");
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

}  // namespace
}  // namespace kerf::app
