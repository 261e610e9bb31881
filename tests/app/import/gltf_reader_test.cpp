namespace kerf::app {
namespace {

constexpr int kByte = 5121;
constexpr int kShort = 5123;
constexpr int kFloat = 5126;

/// A glTF with one mesh of one primitive, whose lists can be added to.
class Gltf {
  public:
    Gltf() {
        json = {{"asset", {{"version", "2.0"}}},
                {"scene", 0},
                {"scenes", {{{"nodes", {0}}}}},
                {"nodes", {{{"mesh", 0}}}},
                {"meshes", {{{"primitives", {{{"attributes", Json::object()}}}}}}},
                {"accessors", Json::array()},
                {"bufferViews", Json::array()}};
    }
    /// A box of 1 x 2 x 3 with a corner at the origin.
    static Gltf box() {
        Gltf gltf;
        TriangleSoup soup = boxSoup(Vec3(1, 2, 3));
        std::vector<float> places;
        for (const Vec3& p : soup.positions) {
            const Vec3f at = (p + Vec3(0.5, 1, 1.5)).cast<float>();
            places.insert(places.end(), at.begin(), at.end());
        }
        std::vector<std::uint16_t> corners;
        for (const Triangle& t : soup.triangles) {
            corners.insert(corners.end(), t.begin(), t.end());
        }
        gltf.attributes()["POSITION"] = gltf.add(places, kFloat, "VEC3");
        gltf.primitive()["indices"] = gltf.add(corners, kShort, "SCALAR");
        return gltf;
    }

    Json& primitive() { return json["meshes"][0]["primitives"][0]; }
    Json& attributes() { return primitive()["attributes"]; }
    int vertices() { return json["accessors"][0]["count"]; }

    template <class T>
    int addView(const std::vector<T>& numbers) {
        while (bytes.size() % 4 != 0) bytes += '\0';
        json["bufferViews"].push_back({{"buffer", 0},
                                       {"byteOffset", bytes.size()},
                                       {"byteLength", numbers.size() * sizeof(T)}});
        bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }
    template <class T>
    int add(const std::vector<T>& numbers, int type, const std::string& kind) {
        const std::map<std::string, int> widths{
            {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
        json["accessors"].push_back({{"bufferView", addView(numbers)},
                                     {"componentType", type},
                                     {"count", numbers.size() / widths.at(kind)},
                                     {"type", kind}});
        return static_cast<int>(json["accessors"].size()) - 1;
    }

    std::string text() {
        json["buffers"] = {{{"uri", "data:application/octet-stream;base64," + base64(bytes)},
                            {"byteLength", bytes.size()}}};
        return json.dump();
    }

    Json json;
    std::string bytes;
};

class GltfReader : public ::testing::Test {
  protected:
    ImportedModel read(Gltf gltf) { return readText(gltf.text()); }
    ImportedModel readText(const std::string& text) {
        writeText(folder_ / "a.gltf", text);
        return readGltf(folder_ / "a.gltf");
    }
    std::string sentence(Gltf gltf) {
        return inputErrorOf([&] { read(std::move(gltf)); });
    }
    static double volumeOf(const ImportedModel& model) {
        const MeshReport report = inspectTriangles(weldExactly(model.soup));
        EXPECT_TRUE(report.cuttable) << report.problem;
        return report.volume;
    }
    test::TemporaryFolder folder_;
};

TEST_F(GltfReader, NodesStandWhereTheirParentsPutThem) {
    EXPECT_NEAR(volumeOf(read(Gltf::box())), 6, 1e-12);
    Gltf gltf = Gltf::box();
    gltf.json["nodes"] = {{{"children", {1}}, {"scale", {2, 2, 2}}},
                          {{"mesh", 0}, {"translation", {10, 0, 0}}}};
    const ImportedModel moved = read(gltf);
    EXPECT_NEAR(volumeOf(moved), 48, 1e-12);
    EXPECT_EQ(boxOf(moved.soup.positions).low, Vec3(20, 0, 0));
    gltf.json["nodes"][0]["scale"] = {-1, 1, 1};
    EXPECT_NEAR(volumeOf(read(gltf)), 6, 1e-12) << "mirrored, and turned back";
    gltf.json["nodes"][1]["children"] = {0};
    EXPECT_THAT(sentence(gltf), HasSubstr("hangs at two others"));
    gltf = Gltf::box();
    gltf.json.erase("scenes");
    EXPECT_NEAR(volumeOf(read(gltf)), 6, 1e-12) << "all nodes, where there is no scene";
}

TEST_F(GltfReader, NumbersMayBeQuantizedInterleavedOrSparse) {
    Gltf gltf = Gltf::box();
    std::vector<std::uint8_t> places;
    const TriangleSoup soup = boxSoup();
    for (const Vec3& p : soup.positions) {
        for (const double x : p) places.push_back(x > 0 ? 255 : 0);
        places.push_back(77);  // up to a multiple of four bytes
    }
    gltf.attributes()["POSITION"] = gltf.add(places, kByte, "VEC4");
    gltf.json["accessors"].back().update({{"type", "VEC3"}, {"normalized", true}});
    gltf.json["bufferViews"].back()["byteStride"] = 4;
    gltf.json["nodes"][0]["scale"] = {1, 2, 3};
    gltf.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    EXPECT_NEAR(volumeOf(read(gltf)), 6, 1e-12);

    Gltf sparse = Gltf::box();
    std::vector<std::uint8_t> top;
    std::vector<float> raised;
    for (std::size_t v = 0; v < soup.positions.size(); ++v) {
        if (soup.positions[v].z() > 0) {
            top.push_back(static_cast<std::uint8_t>(v));
            raised.insert(raised.end(), {soup.positions[v].x() > 0 ? 1.0F : 0.0F,
                                         soup.positions[v].y() > 0 ? 2.0F : 0.0F, 6.0F});
        }
    }
    const int indices = sparse.addView(top);
    const int values = sparse.addView(raised);
    sparse.json["accessors"][0]["sparse"] = {
        {"count", top.size()},
        {"indices", {{"bufferView", indices}, {"componentType", kByte}}},
        {"values", {{"bufferView", values}}}};
    EXPECT_NEAR(volumeOf(read(sparse)), 12, 1e-12);
}

TEST_F(GltfReader, SkinsFollowTheirJointsAndMorphTargetsTheirWeights) {
    Gltf gltf = Gltf::box();
    const std::size_t vertices = gltf.vertices();
    std::vector<std::uint8_t> joints(4 * vertices, 0);
    std::vector<float> weights(4 * vertices, 0);
    for (std::size_t v = 0; v < vertices; ++v) weights[4 * v] = 1;
    gltf.attributes()["JOINTS_0"] = gltf.add(joints, kByte, "VEC4");
    gltf.attributes()["WEIGHTS_0"] = gltf.add(weights, kFloat, "VEC4");
    gltf.json["skins"] = {{{"joints", {1}}}};
    gltf.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"scale", {10, 10, 10}}},
                          {{"translation", {5, 0, 0}}, {"scale", {2, 2, 2}}}};
    gltf.json["scenes"][0]["nodes"] = {0, 1};
    const ImportedModel skinned = read(gltf);
    EXPECT_NEAR(volumeOf(skinned), 48, 1e-9) << "by the joint, not by the node of the mesh";
    EXPECT_EQ(boxOf(skinned.soup.positions).low, Vec3(5, 0, 0));
    gltf.json["scenes"][0]["nodes"] = {0};
    EXPECT_THAT(sentence(gltf), HasSubstr("its joint 1 is not in the scene"));
    gltf.json["skins"][0]["joints"] = Json::array();
    EXPECT_THAT(sentence(gltf), HasSubstr("hangs at a joint that is not there"));

    Gltf morphed = Gltf::box();
    std::vector<float> up;
    for (const Vec3& p : boxSoup().positions) {
        up.insert(up.end(), {0, 0, p.z() > 0 ? 3.0F : 0.0F});
    }
    morphed.primitive()["targets"] = {{{"POSITION", morphed.add(up, kFloat, "VEC3")}}};
    EXPECT_NEAR(volumeOf(read(morphed)), 6, 1e-12);
    morphed.json["meshes"][0]["weights"] = {0.5};
    EXPECT_NEAR(volumeOf(read(morphed)), 9, 1e-12);
    morphed.json["nodes"][0]["weights"] = {1};
    EXPECT_NEAR(volumeOf(read(morphed)), 12, 1e-12);
}

TEST_F(GltfReader, StripsAndFansAreTriangles) {
    Gltf gltf;
    gltf.attributes()["POSITION"] =
        gltf.add(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, kFloat, "VEC3");
    for (const auto& [mode, second] :
         {std::pair{5, Triangle{1, 3, 2}}, std::pair{6, Triangle{0, 2, 3}}}) {
        gltf.primitive()["mode"] = mode;
        const ImportedModel model = read(gltf);
        ASSERT_EQ(model.soup.triangles.size(), 2U);
        EXPECT_EQ(model.soup.triangles[0], (Triangle{0, 1, 2}));
        EXPECT_EQ(model.soup.triangles[1], second);
    }
    gltf.primitive()["mode"] = 1;
    EXPECT_THAT(sentence(gltf), HasSubstr("there is no surface"));
}

TEST_F(GltfReader, TextureCoordinatesAreTransformed) {
    Gltf gltf = Gltf::box();
    std::vector<float> uvs;
    for (int v = 0; v < gltf.vertices(); ++v) uvs.insert(uvs.end(), {0.5F, 0.25F});
    gltf.attributes()["TEXCOORD_1"] = gltf.add(uvs, kFloat, "VEC2");
    gltf.primitive()["material"] = 0;
    gltf.json["images"] = {{{"uri", "my%20tile.png"}}};
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.json["materials"] = {
        {{"name", "wood"},
         {"pbrMetallicRoughness",
          {{"baseColorTexture",
            {{"index", 0},
             {"texCoord", 1},
             {"extensions",
              {{"KHR_texture_transform", {{"scale", {2, 3}}, {"offset", {0.25, 0}}}}}}}}}}}};
    writeText(folder_ / "my tile.png", "bytes");
    const ImportedModel model = read(gltf);
    EXPECT_EQ(model.soup.skin.uvs.front()[0], Eigen::Vector2f(1.25F, 0.25F));
    ASSERT_EQ(model.appearance.images.size(), 1U);
    EXPECT_EQ(model.appearance.images[0].bytes, "bytes");
    EXPECT_EQ(model.appearance.materials[0].roughness, 1);
    EXPECT_EQ(model.soup.skin.materials.front(), 0);
}

TEST_F(GltfReader, WhatIsBrokenOrNotReadIsNamed) {
    Gltf gltf = Gltf::box();
    gltf.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    EXPECT_THAT(sentence(gltf), HasSubstr("needs the glTF extension KHR_draco_mesh_compression"));
    gltf = Gltf::box();
    gltf.json["nodes"][0]["extensions"] = {{"EXT_mesh_gpu_instancing", Json::object()}};
    EXPECT_THAT(sentence(gltf), HasSubstr("needs the glTF extension EXT_mesh_gpu_instancing"));
    gltf = Gltf::box();
    gltf.json["accessors"][0]["count"] = 1000000;
    EXPECT_THAT(sentence(gltf), HasSubstr("it ends within a list of numbers"));
    gltf = Gltf::box();
    gltf.json["accessors"][1]["count"] = "many";
    EXPECT_THAT(sentence(gltf), HasSubstr("its \"count\" is not what glTF has there"));
    gltf = Gltf::box();
    gltf.attributes()["POSITION"] = 17;
    EXPECT_THAT(sentence(gltf), HasSubstr("number 17 of its accessors, which is not there"));
    gltf = Gltf::box();
    gltf.attributes()["POSITION"] = -1;
    EXPECT_THAT(sentence(gltf), HasSubstr("its \"POSITION\" is negative"));
    gltf = Gltf::box();
    gltf.json["meshes"][0]["primitives"][0]["indices"] = 0;
    EXPECT_THAT(sentence(gltf), HasSubstr("is of the type \"VEC3\", which does not belong"));
}

TEST_F(GltfReader, AGlbMayLackTheBytesBetweenItsChunks) {
    Gltf gltf = Gltf::box();
    gltf.json["buffers"] = {{{"byteLength", gltf.bytes.size()}}};
    for (const std::string blanks : {"", " ", "  ", "   "}) {
        const std::string json = gltf.json.dump() + blanks;
        std::string glb = "glTF";
        const auto append = [&](std::uint32_t number) {
            glb.append(reinterpret_cast<const char*>(&number), sizeof number);
        };
        append(2);
        append(static_cast<std::uint32_t>(28 + json.size() + gltf.bytes.size()));
        append(static_cast<std::uint32_t>(json.size()));
        glb += "JSON" + json;
        append(static_cast<std::uint32_t>(gltf.bytes.size()));
        glb += std::string("BIN\0", 4) + gltf.bytes;
        writeText(folder_ / "a.glb", glb);
        EXPECT_NEAR(volumeOf(readGltf(folder_ / "a.glb")), 6, 1e-12) << blanks.size();
        writeText(folder_ / "a.glb", glb.substr(0, glb.size() - 1));
        EXPECT_THROW(readGltf(folder_ / "a.glb"), InputError);
    }
}

}  // namespace
}  // namespace kerf::app
