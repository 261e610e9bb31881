#include "app/link/igtl_message.h"

#include "app/link/blade_link.h"
#include "app/link/link_server.h"

namespace kerf::app {
namespace {

IgtlMessage sent(const IgtlMessage& message) {
    IgtlReader reader;
    reader.add(packIgtl(message));
    return reader.next().value();
}

std::string refusalOf(const std::string& bytes) {
    IgtlReader reader;
    reader.add(bytes);
    try {
        reader.next();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(IgtlMessageTest, BytesAreThoseOfThePublishedFormat) {
    const std::string bytes = packIgtl({"STRING", "Blade", "123456789"});
    ASSERT_EQ(bytes.size(), 58u + 9u);
    EXPECT_EQ(bytes.substr(0, 42),
              std::string("\0\1STRING\0\0\0\0\0\0Blade", 19) + std::string(23, '\0'));
    EXPECT_EQ(bytes.substr(42, 16),
              std::string("\0\0\0\0\0\0\0\x09\x6c\x40\xdf\x5f\x0b\x49\x73\x47", 16))
        << "the check value of CRC-64/ECMA-182";
}

TEST(IgtlMessageTest, AStreamMayComeByteByByte) {
    IgtlReader reader;
    const std::string bytes = packIgtl({"A", "x", "1"}) + packIgtl({"B", "y", ""});
    std::vector<std::string> types;
    for (const char byte : bytes) {
        reader.add({&byte, 1});
        if (const auto message = reader.next()) {
            types.push_back(message->type);
        }
    }
    EXPECT_EQ(types, (std::vector<std::string>{"A", "B"}));
}

TEST(IgtlMessageTest, APoseComesBack) {
    const IgtlPose pose{{1, -2, 3.5}, Vec3(1, 2, 2) / 3};
    const auto back = poseIn(sent({"TRANSFORM", "Blade", transformOf(pose)}), "Blade");
    ASSERT_TRUE(back);
    EXPECT_LT((back->position - pose.position).norm(), 1e-6);
    EXPECT_LT((back->zAxis - pose.zAxis).norm(), 1e-6);
    EXPECT_FALSE(poseIn(sent({"TRANSFORM", "Other", transformOf(pose)}), "Blade"));
    EXPECT_EQ(textIn(sent({"STRING", "Blade", stringOf("lift")})), "lift");
    EXPECT_FALSE(textIn(sent({"STATUS", "Blade", statusOf("lift")})));
}

TEST(IgtlMessageTest, WhatIsNoMessageIsRefused) {
    std::string wrong = packIgtl({"TRANSFORM", "Blade", std::string(48, '\0')});
    wrong.back() = '\1';
    EXPECT_THAT(refusalOf(wrong), HasSubstr("checksum"));
    EXPECT_THAT(refusalOf("GET / HTTP/1.1\r\n" + std::string(58, ' ')), HasSubstr("no message"));
    wrong = packIgtl({"IMAGE", "x", std::string((1u << 16) + 1, '\0')});
    EXPECT_THAT(refusalOf(wrong), HasSubstr("65537 bytes"));
    wrong = packIgtl({"STRING", "x", std::string(12, '\xff')});
    wrong[1] = 2;
    EXPECT_THAT(refusalOf(wrong), HasSubstr("longer than the message"));
    EXPECT_THROW(poseIn({"TRANSFORM", "Blade", std::string(48, '\0')}, "Blade"), InputError);
    EXPECT_THROW(poseIn({"TRANSFORM", "Blade", std::string(48, '\x7f')}, "Blade"), InputError);
    EXPECT_THROW(textIn({"STRING", "Blade", std::string("\0\3\0\5lift", 8)}), InputError);
    EXPECT_THROW(textIn({"STRING", "Blade", ""}), InputError) << "by fuzzing";
    wrong = packIgtl({"STRING", "x", ""});
    wrong[1] = 2;
    EXPECT_THAT(refusalOf(wrong), HasSubstr("longer than the message")) << "by fuzzing";
}

TEST(IgtlMessageTest, AxesAreThoseOfAPatient) {
    EXPECT_EQ(toRas(Vec3::UnitY()), Vec3(0, 0, 1)) << "up is superior";
    EXPECT_EQ(toRas(Vec3::UnitZ()), Vec3(0, -1, 0)) << "the front is posterior";
    EXPECT_EQ(fromRas(toRas({1, 2, 3})), Vec3(1, 2, 3));
}

TEST(LinkServerTest, AnAddressIsOneOfIPv4) {
    EXPECT_EQ(ntohl(readLinkAddress("18944")->sin_addr.s_addr), 0x7F000001u) << "this machine";
    EXPECT_EQ(readLinkAddress("0.0.0.0:18944")->sin_addr.s_addr, 0u);
    EXPECT_EQ(ntohs(readLinkAddress("0.0.0.0:18944")->sin_port), 18944);
    for (const char* wrong : {"", ":", "x", "1:", ":1", "65536", "-1", "1.2.3:4", "localhost:1"}) {
        EXPECT_FALSE(readLinkAddress(wrong)) << wrong;
    }
}

TEST(LinkServerTest, APortThatIsTakenIsRefused) {
    const LinkServer server(*readLinkAddress("0"));
    EXPECT_THROW(LinkServer(*readLinkAddress(server.address())), InputError);
}

}  // namespace
}  // namespace kerf::app
