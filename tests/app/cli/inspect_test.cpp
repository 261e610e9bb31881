// `kerf inspect` of models that are hollow or broken.

#include "sim/base/size_params.h"
#include "tests/support/model_defects.h"

namespace kerf {
namespace {

class Inspect : public ::testing::Test {
  protected:
    std::string file(const std::string& name) const { return folder / name; }
    void write(const std::string& name, const TriangleSoup& soup) const {
        writeText(folder / name, objText(soup));
    }
    static Json reportOf(const std::string& model) {
        return Json::parse(runKerf({"inspect", model, "--json", "--try-repair"}).out);
    }

    TemporaryFolder folder;
};

TEST_F(Inspect, AHollowModelIsOnePieceWithACavity) {
    write("hollow.obj", joined(boxSoup(Vec3(2, 2, 2)), boxSoup(), Vec3::Zero()));
    const ProgramRun run = runKerf({"inspect", file("hollow.obj")});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_NE(run.out.find("turned 1 shell inside another one inwards"), std::string::npos);
    const auto report = reportOf(file("hollow.obj"));
    EXPECT_EQ(report["cavities"], 1);
    EXPECT_EQ(report["pieces"], 1);
    EXPECT_NEAR(report["volume"].get<double>(), 7, 1e-9);
}

TEST_F(Inspect, RepairsWhatIsBroken) {
    TriangleSoup soup = soundBall();
    modelDefects().at("large hole")(soup);
    modelDefects().at("doubles")(soup);
    write("broken.obj", soup);
    const ProgramRun refused = runKerf({"inspect", file("broken.obj"), "--try-repair"});
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_NE(refused.errors.find("inspect MODEL --repair OUT.ply"), std::string::npos);
    EXPECT_TRUE(reportOf(file("broken.obj"))["repairable"]);
    const ProgramRun run = runKerf({"inspect", file("broken.obj"), "--repair", file("mended.ply")});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_NE(run.out.find("filled 1 hole"), std::string::npos) << run.out;
    EXPECT_EQ(runKerf({"inspect", file("mended.ply")}).exitCode, 0);
}

TEST_F(Inspect, LooksForARepairOnlyWhenAsked) {
    write("two.obj", joined(boxSoup(), boxSoup(), Vec3(0.5, 0.4, 0.3)));
    TriangleSoup open = boxSoup();
    open.triangles.pop_back();
    write("open.obj", open);
    for (const char* name : {"two.obj", "open.obj"}) {
        const Json report = Json::parse(runKerf({"inspect", file(name), "--json"}).out);
        EXPECT_TRUE(report["repairable"].is_null()) << name;
        EXPECT_TRUE(report["thickenable"].is_null()) << name;
    }
    EXPECT_THAT(runKerf({"inspect", file("open.obj")}).errors, HasSubstr("--try-repair"));
}

TEST_F(Inspect, WhatARepairIsSaidToDoItDoes) {
    std::map<std::string, TriangleSoup> models;
    for (const char* defect : {"sheets that touch it in vertices", "large hole"}) {
        models[defect] = soundBall();
        modelDefects().at(defect)(models[defect]);
    }
    // Thinner than what is parted at a vertex moves apart.
    models["a spike at a corner"] =
        weldExactly(joined(boxSoup(),
                           {{{0, 0, 0}, {0.9, 0.5, 0}, {0, 0.4, 0.8}, {3e-5, 6e-5, 2e-5}},
                            {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}},
                           Vec3::Constant(0.5)));
    models["a sheet"] = {{{0, 0, 0}, {0.9, 0.1, 0.3}, {1.5, 1.1, 0.8}, {0.6, 1, 0.5}},
                         {{0, 1, 2}, {0, 2, 3}}};
    models["a sheet"] = joined(models["a sheet"], models["a sheet"], Vec3(0, 0, 1));
    for (const auto& [name, model] : models) {
        SCOPED_TRACE(name);
        write("model.obj", model);
        const bool promised = reportOf(file("model.obj"))["repairable"];
        EXPECT_EQ(promised, name != "a sheet");
        const auto run = runKerf({"inspect", file("model.obj"), "--repair", file("mended.ply")});
        EXPECT_EQ(run.exitCode, promised ? 0 : 3) << run.errors;
    }
}

TEST_F(Inspect, SaysThatARepairWouldUniteWhatCrosses) {
    write("two.obj", joined(boxSoup(), boxSoup(), Vec3(0.5, 0.4, 0.3)));
    const ProgramRun run = runKerf({"inspect", file("two.obj"), "--try-repair"});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_NE(run.out.find("would help: united 2 pieces that crossed"), std::string::npos)
        << run.out;
    EXPECT_TRUE(reportOf(file("two.obj"))["repairable"]);
    EXPECT_FALSE(reportOf("sphere80")["repairable"]);
}

/// Two boxes with a material and an image each, of which one is missing.
std::string writePainted(const fs::path& folder, bool open) {
    writePng({3, 2, std::vector<std::uint8_t>(24, 255)}, folder / "tile.png");
    writeText(folder / "paint.mtl",
              "newmtl wood\nmap_Kd tile.png\nnewmtl stone\nmap_Kd gone.png\n");
    TriangleSoup second = boxSoup(Vec3(1, 1, 2));
    second.triangles.resize(second.triangles.size() - (open ? 1 : 0));
    const std::string text = objText(joined(boxSoup(), second, Vec3(3, 0, 0)));
    const auto faces = text.find("f ");
    const auto last = text.rfind("f ");
    writeText(folder / "painted.obj",
              "mtllib paint.mtl\n" + text.substr(0, faces) + "usemtl wood\nvt 0 0\n" +
                  text.substr(faces, last - faces) + "usemtl stone\n" + text.substr(last));
    return folder / "painted.obj";
}

TEST_F(Inspect, TellsInOneScreenWhatAModelHas) {
    for (const bool open : {false, true}) {
        const ProgramRun run = runKerf({"inspect", writePainted(folder.path(), open)});
        EXPECT_EQ(run.exitCode, open ? 3 : 0) << run.errors;
        std::istringstream lines(run.out);
        int count = 0;
        for (std::string line; std::getline(lines, line); ++count) {
            EXPECT_TRUE(line.size() <= 100 || line.starts_with("file ")) << line;
        }
        EXPECT_LE(count, 24) << run.out;
        for (const char* part : {"\nmaterials  2: wood, stone\n", "tile.png",
                                 "\nsize       4 m x 1 m x 2 m, as guessed\n",
                                 "\nremark     The image \"gone.png\" of the material \"stone\""}) {
            EXPECT_NE(run.out.find(part), std::string::npos) << part << run.out;
        }
        EXPECT_EQ(run.errors.find("gone.png"), std::string::npos) << run.errors;
    }
}

TEST_F(Inspect, TellsProgramsTheSame) {
    const auto report = reportOf(writePainted(folder.path(), false));
    EXPECT_EQ(report["format"], "obj");
    EXPECT_EQ(report["size"], Json::array({4, 1, 2}));
    ASSERT_EQ(report["largest_pieces"].size(), 2U);
    EXPECT_NEAR(report["largest_pieces"][0].get<double>(), 2, 1e-9);
    EXPECT_NEAR(report["largest_pieces"][1].get<double>(), 1, 1e-9);
    ASSERT_EQ(report["remarks"].size(), 1U);
    const auto& looks = report["looks"];
    EXPECT_EQ(looks["materials"], Json::parse(R"([{"name": "wood"}, {"name": "stone"}])"));
    EXPECT_EQ(looks["images"], Json::parse(R"([{"name": "tile.png", "width": 3, "height": 2}])"));
    EXPECT_EQ(looks["vertex_colors"], false);
    const auto refused = reportOf(writePainted(folder.path(), true));
    EXPECT_EQ(refused["looks"]["materials"], looks["materials"]);
    EXPECT_EQ(refused["looks"]["images"][0]["name"], "tile.png");
    EXPECT_EQ(refused["remarks"], report["remarks"]);
}

TEST_F(Inspect, ForecastsTheRealTimeFactor) {
    const ProgramRun run = runKerf({"inspect", "sphere80"});
    EXPECT_THAT(run.out, testing::ContainsRegex("\nspeed      about [0-9.]+x real time here "
                                                "\\(time step [0-9.]+ ms, [0-9]+ iterations\\)\n"));
    const auto speed = reportOf("sphere80")["speed"];
    EXPECT_GT(speed["real_time_factor"], 0);
    EXPECT_GT(speed["iterations"], 0);
    EXPECT_EQ(speed["time_step"], suitedTo(2, Params{}).timeStep);
    EXPECT_EQ(speed["problem"], "");
}

TEST_F(Inspect, TellsOfWallsThinnerThanTheirTriangles) {
    const std::string cloth = KERF_SOURCE_DIR "/assets/models/cloth.obj";
    EXPECT_THAT(runKerf({"inspect", cloth}).out,
                HasSubstr("\nwalls      at 100 % of the vertices"));
    const auto walls = reportOf(cloth)["thin_walls"];
    EXPECT_EQ(walls["share"], 1);
    EXPECT_NEAR(walls["thickness"], 5e-3, 1e-6);
    EXPECT_GT(walls["edge"], 5e-3);
    EXPECT_THAT(runKerf({"inspect", "sphere80"}).out, Not(HasSubstr("\nwalls")));
    EXPECT_EQ(reportOf("sphere80")["thin_walls"]["share"], 0);
}

TEST_F(Inspect, NeedsNoOpenGl) {
    const std::map<std::string, std::string> none{{"KERF_FORCE_NO_GL", "1"}};
    const ProgramRun run = runKerf({"inspect", "sphere80"}, none);
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_THAT(run.out, Not(HasSubstr("speed")));
    const auto report = Json::parse(runKerf({"inspect", "sphere80", "--json"}, none).out);
    EXPECT_TRUE(report["speed"]["real_time_factor"].is_null());
    EXPECT_THAT(report["speed"]["problem"], HasSubstr("KERF_FORCE_NO_GL"));
}

TEST_F(Inspect, ForecastsNothingForWhichThereIsNoMemory) {
    const ProgramRun run =
        runKerf({"inspect", "sphere80", "--json"}, {{"KERF_MEMORY_BYTES", "1000000"}});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    const auto speed = Json::parse(run.out)["speed"];
    EXPECT_TRUE(speed["iterations"].is_null());
    EXPECT_THAT(speed["problem"], HasSubstr("needs about"));
}

TEST_F(Inspect, LeavesTheModelAsItIs) {
    write("own.obj", boxSoup());
    const std::string before = readBytes(folder / "own.obj");
    fs::create_symlink("own.obj", folder / "link.obj");
    for (const char* out : {"own.obj", "link.obj"}) {
        for (const char* option : {"--repair", "--remesh"}) {
            const ProgramRun run = runKerf({"inspect", file("own.obj"), option, file(out)});
            EXPECT_EQ(run.exitCode, 2) << out;
            EXPECT_NE(run.errors.find("choose another name"), std::string::npos) << run.errors;
        }
    }
    EXPECT_EQ(readBytes(folder / "own.obj"), before);
}

TEST_F(Inspect, WritesNothingOfWhatCannotBeRepaired) {
    write("sheet.obj", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                        {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}});
    const ProgramRun run = runKerf({"inspect", file("sheet.obj"), "--repair", file("out.ply")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.errors.find("after the repair still"), std::string::npos) << run.errors;
    EXPECT_FALSE(fs::exists(folder / "out.ply"));
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--repair", file("none/out.ply")}).exitCode, 5);
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--repair", file("out.txt")}).exitCode, 2);
}

TEST_F(Inspect, MakesEvenTrianglesWhereFloatsAreFarApart) {
    // A float tells places 0.03 apart there.
    TriangleSoup soup = cubeSphereSoup(12, 0.2);
    for (Vec3& p : soup.positions) {
        p += Vec3::Constant(4e5);
    }
    write("far.obj", soup);
    const ProgramRun run = runKerf({"inspect", file("far.obj"), "--remesh", file("out.ply")});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    const double volume = reportOf(file("far.obj"))["volume"];
    EXPECT_NEAR(reportOf(file("out.ply"))["volume"].get<double>(), volume, 0.01 * volume);
}

TEST_F(Inspect, SendsNoModelToTheOriginThatIsThere) {
    // A needle that is higher than none in doubles alone.
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
        "property double z\nelement face ";
    const std::string body =
        "\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n1 1 0\n0.5 0.3 1\n1.0000000001 0.5 0\n"
        "3 0 2 4\n3 0 4 1\n3 1 4 2\n3 0 1 3\n3 1 2 3\n";
    writeText(folder / "needle.ply", head + "6" + body + "3 2 0 3\n");
    const ProgramRun run = runKerf({"inspect", file("needle.ply"), "--repair", file("out.ply")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.errors.find("32-bit numbers"), std::string::npos) << run.errors;
    EXPECT_EQ(run.errors.find("origin"), std::string::npos) << run.errors;
    EXPECT_EQ(run.errors.find("--edge"), std::string::npos) << run.errors;
    EXPECT_NE(run.errors.find("dissolve them"), std::string::npos) << run.errors;
    writeText(folder / "open.ply", head + "5" + body);
    EXPECT_FALSE(reportOf(file("open.ply"))["repairable"]) << "it would end there, too";
}

TEST_F(Inspect, ProposesEdgesWhereTheSkinIsCoarse) {
    write("cube.obj", boxSoup());
    const ProgramRun run = runKerf({"inspect", file("cube.obj")});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_NE(run.out.find("The mesh is coarse: 12 triangles, edges up to 1.41; --remesh OUT.ply "
                           "--edge 0.069 makes\n           it bend and cut well.\n"),
              std::string::npos)
        << run.out;
    EXPECT_NEAR(reportOf(file("cube.obj"))["proposed_edge"].get<double>(), 0.0693, 1e-4);
    EXPECT_EQ(runKerf({"inspect", file("cube.obj"), "--remesh", file("fine.ply")}).exitCode, 0);
    const auto fine = reportOf(file("fine.ply"));
    EXPECT_TRUE(fine["proposed_edge"].is_null());
    EXPECT_GT(fine["triangles"], 2000);
    EXPECT_NEAR(fine["volume"].get<double>(), 1, 1e-6);
    EXPECT_TRUE(reportOf("sphere768")["proposed_edge"].is_null());
}

TEST_F(Inspect, GivesASheetAThickness) {
    write("sheet.obj", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                        {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}});
    const ProgramRun refused = runKerf({"inspect", file("sheet.obj"), "--try-repair"});
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_NE(refused.out.find("would help, with --thickness 0.028"), std::string::npos);
    EXPECT_NE(refused.errors.find("inspect MODEL --thicken OUT.ply"), std::string::npos);
    const auto report = reportOf(file("sheet.obj"));
    EXPECT_EQ(report["thickenable"], true);
    EXPECT_EQ(report["proposed_thickness"], 0.028);
    EXPECT_EQ(report["repairable"], false);
    const auto thicken = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"inspect", file("sheet.obj"), "--thicken", file("out.ply")};
        words.insert(words.end(), more.begin(), more.end());
        return runKerf(words);
    };
    const ProgramRun proposed = thicken({});
    EXPECT_EQ(proposed.exitCode, 0) << proposed.errors;
    EXPECT_NE(proposed.out.find("gave 1 sheet a thickness of 0.028"), std::string::npos);
    EXPECT_NEAR(reportOf(file("out.ply"))["volume"].get<double>(), 0.028, 1e-7);
    EXPECT_EQ(thicken({"--thickness", "0.25"}).exitCode, 0);
    EXPECT_NEAR(reportOf(file("out.ply"))["volume"].get<double>(), 0.25, 1e-7);
    EXPECT_EQ(reportOf(file("out.ply"))["thickenable"], false);
    EXPECT_EQ(thicken({"--thickness", "-1"}).exitCode, 2);
    EXPECT_EQ(thicken({"--repair", file("other.ply")}).exitCode, 2);
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--thickness", "0.1"}).exitCode, 2);
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--thicken", file("ball.ply")}).exitCode, 0);
}

TEST_F(Inspect, ASheetThatIsThereForEachSideBecomesOneBody) {
    TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    for (int t = 0; t < 4; ++t) {
        soup.triangles.push_back(
            {soup.triangles[t][1], soup.triangles[t][0], soup.triangles[t][2]});
    }
    write("both.obj", soup);
    EXPECT_EQ(reportOf(file("both.obj"))["thickenable"], true);
    EXPECT_EQ(runKerf({"inspect", file("both.obj"), "--thicken", file("out.ply")}).exitCode, 0);
    EXPECT_NEAR(reportOf(file("out.ply"))["volume"].get<double>(), 0.028, 1e-7);
}

TEST_F(Inspect, TooThickASheetIsRefusedWithAThicknessThatDoes) {
    TriangleSoup bowl = icosphereSoup(3);
    std::erase_if(bowl.triangles,
                  [&](const Triangle& t) { return bowl.positions[t[0]].y() > 0.1; });
    write("bowl.obj", weldExactly(bowl));
    const ProgramRun run =
        runKerf({"inspect", file("bowl.obj"), "--thicken", file("out.ply"), "--thickness", "1.5"});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.errors.find("bowl.obj: a thickness of 1.5 is too much"), std::string::npos);
    EXPECT_NE(run.errors.find("; 0.38 does"), std::string::npos) << run.errors;
    EXPECT_FALSE(fs::exists(folder / "out.ply"));
    EXPECT_EQ(
        runKerf({"inspect", file("bowl.obj"), "--thicken", file("out.ply"), "--thickness", "0.38"})
            .exitCode,
        0);
}

TEST_F(Inspect, MakesEvenTriangles) {
    ASSERT_EQ(
        runKerf({"inspect", "sphere80", "--remesh", file("fine.ply"), "--edge", "0.1"}).exitCode,
        0);
    const auto fine = reportOf(file("fine.ply"));
    EXPECT_EQ(fine["cuttable"], true);
    EXPECT_GT(fine["triangles"], 500);
    EXPECT_NEAR(fine["volume"].get<double>(), 0.4573, 0.0046);
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--edge", "0.1"}).exitCode, 2);
}

TEST_F(Inspect, EdgesThatMakeTooManyTrianglesAreRefusedAtOnce) {
    for (const char* edge : {"0.00001", "1e-30", "1e-200"}) {
        const ProgramRun run =
            runKerf({"inspect", "sphere80", "--remesh", file("fine.ply"), "--edge", edge});
        EXPECT_EQ(run.exitCode, 5) << run.errors;
        EXPECT_NE(run.errors.find("ask for longer ones with --edge"), std::string::npos);
    }
    for (const char* edge : {"0", "-1", "nan", "inf", "1x", ""}) {
        const ProgramRun run =
            runKerf({"inspect", "sphere80", "--remesh", file("fine.ply"), "--edge", edge});
        EXPECT_EQ(run.exitCode, 2) << edge;
        EXPECT_NE(run.errors.find("is no length above zero"), std::string::npos) << run.errors;
    }
    EXPECT_FALSE(fs::exists(folder / "fine.ply"));
}

constexpr std::array<int, 3> kOpen{213, 94, 0};
constexpr std::array<int, 3> kOpposed{204, 121, 167};
constexpr std::array<int, 3> kDouble{0, 158, 115};
constexpr std::array<int, 3> kNeedle{230, 159, 0};

TEST_F(Inspect, APictureHasLinesOfEachFaultAndItsLegend) {
    TriangleSoup soup = soundBall();
    modelDefects().at("large hole")(soup);
    modelDefects().at("turned triangles")(soup);
    modelDefects().at("doubles")(soup);
    write("broken.obj", soup);
    const ProgramRun run = runKerf(
        {"inspect", file("broken.obj"), "--picture", file("broken.png"), "--size", "640x480"});
    EXPECT_EQ(run.exitCode, 3) << run.errors;
    EXPECT_NE(run.out.find("vertices"), std::string::npos) << "the report comes all the same";
    const render::Image picture = render::readPng(folder / "broken.png");
    EXPECT_EQ(picture.width, 640);
    EXPECT_EQ(picture.height, 480);
    for (const auto& color : {kOpen, kOpposed, kDouble}) {
        EXPECT_GT(pixelsOf(color, picture.pixels), 150);
    }
    EXPECT_EQ(pixelsOf(kNeedle, picture.pixels), 0);
}

TEST_F(Inspect, APictureOfASoundModelHasNoLines) {
    const ProgramRun run = runKerf({"inspect", "sphere80", "--picture", file("ball.png")});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    const render::Image picture = render::readPng(folder / "ball.png");
    EXPECT_EQ(picture.width, 1280);
    for (const auto& color : {kOpen, kOpposed, kDouble, kNeedle}) {
        EXPECT_EQ(pixelsOf(color, picture.pixels), 0);
    }
}

TEST_F(Inspect, APictureShowsWhatARepairLeaves) {
    TriangleSoup soup = boxSoup(Vec3(1, 20, 1));
    soup.triangles.erase(soup.triangles.begin());
    write("open.obj", soup);
    const ProgramRun run = runKerf({"inspect", file("open.obj"), "--repair", file("closed.ply"),
                                    "--picture", file("closed.png")});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    const render::Image picture = render::readPng(folder / "closed.png");
    EXPECT_EQ(pixelsOf(kOpen, picture.pixels), 0);
    EXPECT_GT(pixelsOf(kNeedle, picture.pixels), 150);
}

TEST_F(Inspect, RefusesPicturesThatCannotBe) {
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--picture", file("ball.jpg")}).exitCode, 2);
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--picture", file("none/ball.png")}).exitCode, 5);
    for (const char* size : {"640", "640x", "0x480", "640x480x3", "-1x5", "9000x10", ""}) {
        EXPECT_EQ(
            runKerf({"inspect", "sphere80", "--picture", file("b.png"), "--size", size}).exitCode,
            2)
            << size;
    }
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--size", "640x480"}).exitCode, 2);
    EXPECT_EQ(runKerf({"inspect", file("none.obj"), "--picture", file("b.png")}).exitCode, 3);
    EXPECT_FALSE(fs::exists(folder / "b.png"));
}

}  // namespace
}  // namespace kerf
