namespace kerf::app {
namespace {

std::string errorOf(const std::string& text) {
    return inputErrorOf([&] { parseSession(text, "/folder"); });
}

TEST(SessionReader, WarnsOfTwoFilesOfOneName) {
    const Session session = parseSession(sessionThatDoes(R"(
        {"step": 1, "type": "screenshot", "file": "a.png"},
        {"step": 3, "type": "screenshot", "file": "a.png"})"),
                                         "");
    EXPECT_EQ(session.warnings, std::vector<std::string>{
                                    "events: at step 3 a.png takes the place of an earlier file of "
                                    "that name."});
}

TEST(SessionReader, ReadsFurtherModelsAndWritesThemAgain) {
    const std::string text = sessionWith(
        R"("more_models": [{"builtin": "sphere80", "placement": {"translate": [2, 0, 0]}},
                           {"path": "cup.obj", "color": [1, 0.5, 0]}],
           "params": {"density@1": 900, "youngs_modulus@2": 20000})");
    const Session session = parseSession(text, "/folder");
    ASSERT_EQ(session.moreModels.size(), 2u);
    EXPECT_EQ(session.moreModels[0].model.builtin, "sphere80");
    EXPECT_EQ(session.moreModels[0].placement.translate, Vec3(2, 0, 0));
    EXPECT_EQ(session.moreModels[1].model.path, "/folder/cup.obj");
    EXPECT_EQ(*session.moreModels[1].color, Vec3(1, 0.5, 0));
    const Session again = parseSession(formatSession(session, "/folder"), "/folder");
    ASSERT_EQ(again.moreModels.size(), 2u);
    EXPECT_EQ(again.moreModels[1].model.path, "/folder/cup.obj");
    EXPECT_EQ(again.moreModels[0].placement, session.moreModels[0].placement);
    EXPECT_TRUE(again.params == session.params);
}

TEST(SessionReader, RefusesParametersOfModelsThatThereAreNot) {
    EXPECT_EQ(errorOf(sessionWith(R"("params": {"density@1": 900})")),
              "params.density@1: there is no model 1; the session has 1 model, numbered from 0.");
    EXPECT_EQ(errorOf(sessionWith(R"("more_models": [{"color": [1, 1, 1]}])")),
              "more_models[0]: expected either \"builtin\" or \"path\".");
}

TEST(SessionReader, LoadsAllModelsOneBehindTheOther) {
    const Session session =
        parseSession(sessionWith(R"("more_models": [{"builtin": "sphere80", "color": [0, 0, 1],
                                        "placement": {"translate": [2, 0, 0]}}])"),
                     ".");
    const ModelMesh scene = loadSessionModel(session);
    ASSERT_EQ(scene.placed.size(), 2u);
    EXPECT_EQ(scene.mesh.aliveTriangles(), 20 + 80);
    EXPECT_EQ(scene.mesh.restPosition(scene.placed[1].firstVertex).x() > 1, true);
    ASSERT_EQ(scene.looks.skin.materials.size(), 100u);
    EXPECT_EQ(scene.looks.skin.materials[19], -1);
    EXPECT_EQ(scene.looks.skin.materials[20], 0);
    EXPECT_EQ(scene.looks.appearance->materials[0].baseColor.head<3>(), Eigen::Vector3f(0, 0, 1));
}

TEST(SessionReader, MinimalSessionHasDefaults) {
    const Session session = parseSession(sessionWith(""), "/folder");
    EXPECT_EQ(session.model.builtin, "sphere20");
    EXPECT_EQ(session.steps, 100);
    EXPECT_TRUE(session.params == Params{});
    EXPECT_FALSE(session.view.has_value());
    EXPECT_TRUE(session.warnings.empty());
}

TEST(SessionReader, ReadsEveryKey) {
    const Session session = parseSession(sessionWithEveryKey(), "/folder");
    EXPECT_EQ(session.model.path, "/folder/model.obj");
    EXPECT_EQ(session.placement.scale, 2);
    EXPECT_EQ(session.placement.rotate, Vec3(10, 20, 30));
    EXPECT_EQ(session.placement.translate, Vec3(1, 2, 3));
    EXPECT_EQ(session.params.timeStep, 0.004);
    EXPECT_EQ(session.params.iterations, 7);
    EXPECT_EQ(session.params.gravity, Vec3(0, -1, 0));
    EXPECT_FALSE(session.params.floor.has_value());
    ASSERT_EQ(session.events.size(), 6u);
    EXPECT_EQ(std::get<MoveBlade>(session.events[0].action).blade.b, Vec3(3, 4, 5));
    EXPECT_TRUE(std::holds_alternative<LiftBlade>(session.events[1].action));
    EXPECT_EQ(std::get<double>(std::get<SetParam>(session.events[2].action).value), -2.5);
    EXPECT_EQ(std::get<ScreenshotEvent>(session.events[3].action).file, "shots/a.png");
    EXPECT_EQ(std::get<ExportEvent>(session.events[4].action).file, "a.stl");
    EXPECT_EQ(std::get<CheckEvent>(session.events[5].action).pieces, 2);
    EXPECT_EQ(session.view->fovY, 50);
}

TEST(SessionReader, UnknownExtraKeysAreWarnings) {
    const Session session = parseSession(
        sessionWith(R"("author": "x", "events": [{"step": 1, "type": "lift", "why": 0}])"), "/");
    EXPECT_EQ(session.warnings, (std::vector<std::string>{"events[0].why: unknown key, ignored.",
                                                          "author: unknown key, ignored."}));
    const Session named = parseSession(sessionWith(R"("$schema": "session.schema.json")"), "/");
    EXPECT_EQ(named.warnings, std::vector<std::string>{});
    EXPECT_EQ(formatSession(named).find("$schema"), std::string::npos);
}

TEST(SessionReader, AnEndingMayBeInCapitals) {
    const Session session = parseSession(
        sessionWithEvent(R"({"step": 1, "type": "screenshot", "file": "a.PNG"})"), "/");
    EXPECT_EQ(std::get<ScreenshotEvent>(session.events[0].action).file, "a.PNG");
}

TEST(SessionReader, EventsOfOneStepKeepTheirOrder) {
    const Session session =
        parseSession(sessionWith(R"("events": [{"step": 5, "type": "export", "file": "b.ply"},
                                  {"step": 1, "type": "lift"},
                                  {"step": 5, "type": "export", "file": "a.ply"}])"),
                     "/");
    EXPECT_EQ(std::get<ExportEvent>(session.events[1].action).file, "b.ply");
    EXPECT_EQ(std::get<ExportEvent>(session.events[2].action).file, "a.ply");
}

class SessionErrors : public ::testing::TestWithParam<BrokenSession> {};

TEST_P(SessionErrors, NameThePlace) {
    EXPECT_EQ(errorOf(GetParam().text).substr(0, GetParam().error.size()), GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(All, SessionErrors, ::testing::ValuesIn(brokenSessions()),
                         [](const auto& each) { return each.param.name; });

TEST(SessionReader, DeepNestingIsRefusedWhileParsing) {
    const std::string deep = "{\"x\": " + std::string(200'000, '[');
    EXPECT_EQ(errorOf(deep), "x: nested deeper than 32 levels.");
    EXPECT_EQ(errorOf(std::string(200'000, '[')), "nested deeper than 32 levels.");
}

TEST(SessionReader, LongNamesAreQuotedInPart) {
    const std::string error = errorOf(
        sessionWithEvent("{\"step\": 1, \"type\": \"\u00e4" + std::string(5000, 'x') + "\"}"));
    EXPECT_EQ(error.find("events[0].type: there is no event type '\u00e4xxx"), 0u) << error;
    EXPECT_LT(error.size(), 400u);
}

TEST(SessionReader, NothingIsLeftUnreadAfterAZeroByte) {
    const std::string text = sessionWith(R"("steps": 3)");
    const std::string error = errorOf(text + std::string(1, '\0') + "more");
    EXPECT_NE(error.find("a zero byte is not valid JSON."), std::string::npos) << error;
}

TEST(SessionReader, ErrorsOfAFileNameIt) {
    const test::TemporaryFolder folder;
    writeText(folder / "bad.kerf.json",
              sessionWithEvent(R"({"step": 1, "type": "blade", "a": 1, "b": [0, 0, 0]})"));
    EXPECT_EQ(inputErrorOf([&] { readSession(folder / "bad.kerf.json"); }),
              "bad.kerf.json: events[0].a: expected three numbers.");
    EXPECT_THROW(readSession(folder / "none.kerf.json"), InputError);
    EXPECT_THROW(readSession(folder.path()), InputError);
    fs::resize_file(folder / "bad.kerf.json", kMaxSessionBytes + 1);
    EXPECT_THAT(inputErrorOf([&] { readSession(folder / "bad.kerf.json"); }),
                Not(HasSubstr("events[0]")))
        << "too large, so unread";
}

/// The sentence with which the model of a session is refused; empty where it is not. `more`: keys.
std::string refusalOfModel(const std::string& placement, const std::string& more = "") {
    return inputErrorOf([&] {
        loadSessionModel(parseSession(sessionWith("\"placement\": " + placement + more), "."));
    });
}

TEST(SessionModel, MustBeWhereFloatsAreFineEnough) {
    EXPECT_EQ(refusalOfModel(R"({"translate": [10000, 0, 0]})"), "");
    EXPECT_EQ(refusalOfModel(R"({"scale": 100000, "translate": [500000, 0, 0]})"), "");
    EXPECT_EQ(refusalOfModel(R"({"translate": [500000, 100, -5000000]})"), "");
    EXPECT_EQ(refusalOfModel(R"({"scale": 1e-4, "translate": [0, -10, 0]})"), "");
    for (const char* placement : {R"({"translate": [2e7, 0, 0]})", R"({"scale": 1e-6})",
                                  R"({"scale": 1e6, "translate": [1e7, 0, 0]})"}) {
        const std::string sentence = refusalOfModel(placement);
        EXPECT_EQ(sentence.find("placement: the model would be"), 0) << placement << sentence;
    }
    const std::string apart = refusalOfModel("{}", R"(, "more_models": [{"builtin": "sphere20",
        "placement": {"translate": [1e5, 0, 0]}}])");
    EXPECT_NE(apart.find("from the middle of the scene"), std::string::npos) << apart;
}

TEST(SessionWriter, RoundTripKeepsEveryBit) {
    const Session session = parseSession(sessionWithEveryEvent(), "/folder");
    const std::string text = formatSession(session);
    const Session again = parseSession(text, "/folder");
    EXPECT_EQ(formatSession(again), text);
    EXPECT_TRUE(again.params == session.params);
    EXPECT_EQ(again.placement.rotate, session.placement.rotate);
    ASSERT_EQ(session.boxes.size(), 2u);
    EXPECT_EQ(again.boxes, session.boxes);
    EXPECT_EQ(session.boxes[1].rotate, Vec3(30, 0.1, -7));
    ASSERT_EQ(again.events.size(), session.events.size());
    EXPECT_EQ(std::get<MoveBlade>(again.events[0].action).blade.a, Vec3(0.1, 1e-300, 3));
    EXPECT_EQ(again.view->eye, session.view->eye);
    EXPECT_TRUE(again.view->orthographic);
    EXPECT_EQ(again.colors.skin, Vec3(0.2, 0.5, 1));
    EXPECT_EQ(again.colors.flesh, Vec3(1, 0.9, 0));
    EXPECT_TRUE(again.colors.ofLook);
    EXPECT_TRUE(again.warnings.empty());
}

TEST(SessionWriter, ModelPathsAreRelativeToTheFolder) {
    Session session = parseSession(sessionWith(""), "/");
    session.model.builtin = "";
    session.model.path = "/data/models/a.obj";
    const std::string text = formatSession(session, "/data/sessions");
    EXPECT_NE(text.find(R"("path":"../models/a.obj")"), std::string::npos);
    EXPECT_EQ(parseSession(text, "/data/sessions").model.path, "/data/models/a.obj");
}

TEST(SessionWriter, KeepsWhatMendsItsModels) {
    const std::string text = R"({"format": "kerf-session", "version": 1, "steps": 1,
        "model": {"builtin": "sphere20", "remesh": true, "remesh_edge": 0.2},
        "more_models": [{"builtin": "banana", "repair": true, "remesh": true},
                        {"builtin": "banana", "fill_holes": true, "thicken": 0.5}]})";
    const Session read = parseSession(text, "/");
    const Session again = parseSession(formatSession(read), "/");
    for (const Session& session : {read, again}) {
        EXPECT_TRUE(session.warnings.empty());
        EXPECT_TRUE(session.model.remesh);
        EXPECT_EQ(session.model.edge, 0.2);
        EXPECT_FALSE(session.model.repair);
        EXPECT_TRUE(session.moreModels.at(0).model.remesh);
        EXPECT_TRUE(session.moreModels.at(0).model.repair);
        EXPECT_FALSE(session.moreModels.at(1).model.remesh);
        EXPECT_EQ(session.moreModels.at(1).model.thicken, 0.5);
        EXPECT_FALSE(session.model.thicken);
    }
    EXPECT_EQ(formatSession(parseSession(sessionWith(""), "/")).find("remesh"), std::string::npos);
}

TEST(SessionLoading, EvenTrianglesAreTheSameEachTimeAndOfOneSize) {
    Session session = parseSession(sessionWith(R"("more_models": [{"builtin": "sphere80"}])"), "/");
    session.model.builtin = "banana";
    session.model.remesh = true;
    const SurfaceMesh first = loadSessionModel(session).mesh;
    const SurfaceMesh second = loadSessionModel(session).mesh;
    EXPECT_EQ(first.restPositions(), second.restPositions());
    session.model.edge = 0.05;
    EXPECT_LT(loadSessionModel(session).mesh.aliveTriangles(), first.aliveTriangles());
    session.model.remesh = false;
    const SurfaceMesh asItIs = loadSessionModel(session).mesh;
    EXPECT_NE(first.aliveTriangles(), asItIs.aliveTriangles());
    EXPECT_NEAR(meshVolume(first), meshVolume(asItIs), 0.01 * meshVolume(asItIs));
}

TEST(SessionWriter, RefusesWhatIsNotFiniteAndANameThatIsNotUtf8) {
    Session session = parseSession(sessionWith(""), "/");
    session.events.push_back({1, MoveBlade{{Vec3(0, NAN, 0), Vec3(1, 0, 0)}}});
    EXPECT_THROW(formatSession(session), InputError);
    session.events.clear();
    EXPECT_NO_THROW(formatSession(session, "/data"));
    session.model.builtin = "";
    session.model.path = "/data/\xff.obj";
    EXPECT_THROW(formatSession(session, "/data"), InputError);
}

TEST(Placement, ScalesThenTurnsAboutXThenYThenZThenMoves) {
    Placement placement;
    placement.scale = 2;
    placement.rotate = {90, 0, 90};
    placement.translate = {0, 0, 10};
    // (0, 1, 0) -> (0, 2, 0) -> about x (0, 0, 2) -> about z the same -> moved.
    EXPECT_TRUE(placement.apply({0, 1, 0}).isApprox(Vec3(0, 0, 12), 1e-12));
    // (1, 0, 0) -> (2, 0, 0) -> about x the same -> about z (0, 2, 0) -> moved.
    EXPECT_TRUE(placement.apply({1, 0, 0}).isApprox(Vec3(0, 2, 10), 1e-12));
}

TEST(Sha256, MatchesThePublishedVectors) {
    const test::TemporaryFolder folder;
    writeText(folder / "empty", "");
    writeText(folder / "abc", "abc");
    EXPECT_EQ(sha256OfFile(folder / "empty"),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256OfFile(folder / "abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace kerf::app
