// Names that stand in files of others, and links that lie where results go: nothing outside is
// made, written or removed.
#include "app/files/io/output_folder.h"

#include "app/files/io/system_file.h"

namespace kerf::app {
namespace {

/// Results go to `out`; `elsewhere` has a file that is nobody's business.
class OutputPaths : public ::testing::Test {
  protected:
    OutputPaths() {
        fs::create_directories(folder_ / "elsewhere");
        fs::create_directories(folder_ / "out");
        writeText(kept_, "mine");
    }
    ~OutputPaths() override {
        EXPECT_EQ(readBytes(kept_), "mine");
        int count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / "elsewhere")) {
            EXPECT_EQ(entry.path(), kept_);
            ++count;
        }
        EXPECT_EQ(count, 1);
    }

    test::TemporaryFolder folder_;
    fs::path kept_ = folder_ / "elsewhere/kept.png";
    OutputFolder out_{folder_ / "out"};
};

TEST_F(OutputPaths, NamesThatLeadOutAreRefused) {
    for (const std::string& name :
         {std::string("../elsewhere/kept.png"), kept_.string(), std::string("a/../../kept.png"),
          std::string(".."), std::string("."), std::string(), std::string("a/"),
          std::string("a.png\0", 6), std::string("..\0/x", 5), std::string(5000, 'a')}) {
        EXPECT_FALSE(isNameInside(name)) << name;
        EXPECT_THROW(out_.write(name, "x"), OutputError) << name;
        EXPECT_THROW(out_.remove(name), OutputError) << name;
    }
    EXPECT_TRUE(fs::is_empty(folder_ / "out"));
}

TEST_F(OutputPaths, WhatABrokenOffRunLeftIsRemovedByItsNameAlone) {
    const std::vector<std::string> left{".a.csv.1.part", ".a.csv.31000.part"};
    const std::vector<std::string> others{".b.csv.1.part", ".a.csv.part", ".a.csv..part",
                                          ".a.csv.1x.part", "a.csv"};
    for (const std::string& name : left) {
        out_.write(name, "x");
    }
    for (const std::string& name : others) {
        out_.write(name, "x");
    }
    out_.removeUnfinished("a.csv");
    for (const std::string& name : left) {
        EXPECT_FALSE(fs::exists(folder_ / "out" / name)) << name;
    }
    for (const std::string& name : others) {
        EXPECT_TRUE(fs::exists(folder_ / "out" / name)) << name;
    }
}

TEST_F(OutputPaths, OneAtATimeHoldsAFolder) {
    {
        const FolderLock first(folder_ / "out");
        EXPECT_THROW(FolderLock(folder_ / "out"), OutputError);
        EXPECT_NO_THROW(FolderLock(folder_ / "elsewhere"));
    }
    EXPECT_NO_THROW(FolderLock(folder_ / "out"));
    EXPECT_TRUE(fs::is_empty(folder_ / "out"));
}

TEST_F(OutputPaths, NamesThatOnlyLookLikeAWayOutStayInside) {
    for (const char* name : {"~/a.png", "..a.png", "a/../b.png", "a b.png"}) {
        EXPECT_TRUE(isNameInside(name)) << name;
        out_.write(name, "x");
        EXPECT_EQ(readBytes(folder_ / "out" / name), "x") << name;
    }
}

TEST_F(OutputPaths, ALinkToAFileOutsideIsNotWrittenThrough) {
    fs::create_symlink(kept_, folder_ / "out/a.png");
    EXPECT_THROW(out_.write("a.png", "x"), OutputError);
    EXPECT_THROW(out_.pathOf("a.png"), OutputError);
}

TEST_F(OutputPaths, RemovingALinkLeavesWhereItLeads) {
    fs::create_symlink(kept_, folder_ / "out/a.png");
    out_.remove("a.png");
    EXPECT_FALSE(fs::is_symlink(folder_ / "out/a.png"));
}

TEST_F(OutputPaths, NothingIsMadeOrRemovedBehindALinkToAFolderOutside) {
    fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "out/sub");
    EXPECT_THROW(out_.remove("sub/kept.png"), OutputError);
    EXPECT_THROW(out_.write("sub/kept.png", "x"), OutputError);
    EXPECT_THROW(out_.write("sub/new/deeper/a.png", "x"), OutputError);
}

TEST_F(OutputPaths, ALinkWithinTheFolderIsFollowed) {
    writeText(folder_ / "out/b.png", "old");
    fs::create_symlink("b.png", folder_ / "out/a.png");
    out_.write("a.png", "new");
    EXPECT_EQ(readBytes(folder_ / "out/b.png"), "new");
}

TEST_F(OutputPaths, ALinkThatLeadsNowhereIsReplaced) {
    fs::create_symlink(folder_ / "out/nowhere", folder_ / "out/a.png");
    out_.write("a.png", "new");
    EXPECT_FALSE(fs::is_symlink(folder_ / "out/a.png"));
    EXPECT_FALSE(fs::exists(folder_ / "out/nowhere"));
}

TEST_F(OutputPaths, TheHiddenNameOfAFileFollowsNoLink) {
    const std::string hidden = ".a.txt." + std::to_string(::getpid()) + ".part";
    fs::create_symlink(kept_, folder_ / ("out/" + hidden));
    out_.write("a.txt", "new");
    EXPECT_EQ(readBytes(folder_ / "out/a.txt"), "new");
}

TEST_F(OutputPaths, NamesOfScenesLeadNowhere) {
    const std::pair<std::string, std::string> names[] = {{"ball", "ball"},
                                                         {"../../ball", "ball"},
                                                         {"/etc/passwd", "passwd"},
                                                         {"..", "_.."},
                                                         {"a/", "_"},
                                                         {"", "_"},
                                                         {"a\nb\x1b[31m", "a_b_[31m"},
                                                         {std::string("a\0b", 3), "a_b"}};
    for (const auto& [name, plain] : names) {
        EXPECT_EQ(plainName(name), plain);
        EXPECT_EQ(plainName(plain), plain);
        EXPECT_EQ(freeFile(folder_ / "out", name, ".png").parent_path(), folder_ / "out") << name;
    }
    EXPECT_LE(plainName(std::string(1000, 'a')).size(), 200U);
}

}  // namespace
}  // namespace kerf::app
