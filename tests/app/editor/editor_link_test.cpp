// A client of OpenIGTLink leads the blade of the window.

#include <arpa/inet.h>
#include <sys/socket.h>

#include "app/link/blade_link.h"

namespace kerf::app {
namespace {

/// In this process: what it sends has come at once.
class Client {
  public:
    explicit Client(sockaddr_in server) {
        auto* const there = reinterpret_cast<sockaddr*>(&server);
        EXPECT_EQ(::connect(socket_.get(), there, sizeof(server)), 0);
    }
    void send(const IgtlMessage& message) const {
        const std::string bytes = packIgtl(message);
        EXPECT_EQ(::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(bytes.size()));
    }
    /// A blade to the right from `tip` on, in the axes of Kerf [m].
    void pose(const Vec3& tip) const {
        send({"TRANSFORM", "Blade", transformOf({kMillimetres * toRas(tip), Vec3::UnitX()})});
    }
    void lift() const { send({"STRING", "Blade", stringOf("lift")}); }
    /// What has come so far, by type and name.
    std::set<std::string> received() {
        std::array<char, 1u << 16> bytes;
        for (ssize_t n = 1; n > 0;) {
            n = ::recv(socket_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
            reader_.add({bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(0, n))});
        }
        std::set<std::string> all;
        while (const auto message = reader_.next()) {
            all.insert(message->type + " " + message->device);
        }
        return all;
    }

  private:
    Descriptor socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
    IgtlReader reader_;
};

class EditorLinkTest : public EditorTest {
  protected:
    void toggle() { tap(Key::l, {.control = true}, 1); }
    const std::string& state() const { return panels().view.link; }
    /// Of a link that is on.
    sockaddr_in address() const {
        return readLinkAddress(state().substr(state().rfind(' ') + 1)).value();
    }
    Simulation& simulation() { return editor->scene()->simulation(); }
    /// From above down to a height, by a pose a picture.
    void lead(const Client& client, double to) {
        for (double y = 0.7; y > to; y -= 0.05) {
            client.pose({-0.85, y, 0.03});
            frames(1);
        }
    }
    /// As long as a session that was saved now, without the editor.
    void expectSameBitsAgain() {
        const Document document = sphereDocument();
        const Session session = editor->scene()->recorder().savedSession({}, {}).session;
        EXPECT_EQ(replayedHash(session, {document.mesh, document.looks}), simulation().stateHash());
    }
};

TEST_F(EditorLinkTest, AClientCutsTheBallAndTheSavedSessionHasTheSameBits) {
    EXPECT_EQ(state(), "");
    toggle();
    ASSERT_THAT(state(), StartsWith("Link: 0 clients on 127.0.0.1:"));
    Client client(address());
    frames(2);
    EXPECT_THAT(state(), StartsWith("Link: 1 client on 127.0.0.1:"));
    lead(client, -0.7);
    client.lift();
    frames(1);
    settle();
    EXPECT_EQ(simulation().report().pieces, 2);
    EXPECT_FALSE(simulation().blade());
    EXPECT_THAT(client.received(), ::testing::IsSupersetOf({"STATUS Kerf", "POLYDATA KerfBody",
                                                            "TRANSFORM KerfBlade"}));
    expectSameBitsAgain();
    undo();
    EXPECT_EQ(simulation().report().pieces, 1) << "like any other stroke";
}

TEST_F(EditorLinkTest, AClientThatLeavesLiftsTheBlade) {
    toggle();
    {
        const Client client(address());
        lead(client, 0.2);
        EXPECT_TRUE(simulation().blade());
    }
    frames(2);
    settle();
    EXPECT_FALSE(simulation().blade());
    EXPECT_THAT(state(), StartsWith("Link: 0 clients"));
    EXPECT_EQ(simulation().strokes().size(), 1u);
    expectSameBitsAgain();
}

TEST_F(EditorLinkTest, ThePointerWaitsForABladeThatAClientLeads) {
    toggle();
    const Client client(address());
    lead(client, 0.2);
    dragAndSettle(kTop, kBottom, 12);
    EXPECT_EQ(simulation().strokes().size(), 1u) << "of the client alone";
    EXPECT_TRUE(simulation().blade()) << "which still holds it";
    toggle();
    settle();
    EXPECT_EQ(state(), "");
    EXPECT_FALSE(simulation().blade());
    dragAndSettle(kTop, kBottom, 12);
    EXPECT_EQ(simulation().report().pieces, 2);
    expectSameBitsAgain();
}

TEST_F(EditorLinkTest, TheGuillotineWaitsToo) {
    tap(Key::g);
    toggle();
    const Client client(address());
    lead(client, 0.2);
    tap(Key::enter);
    settle();
    EXPECT_EQ(panels().tools.guillotine.lowered, 0);
    client.lift();
    frames(1);
    settle();
    EXPECT_EQ(simulation().report().pieces, 1) << "only the client has cut";
}

TEST_F(EditorLinkTest, APortThatIsTakenIsTold) {
    const LinkServer other(*readLinkAddress("0"));
    EditorOptions taken = options();
    taken.link = other.address();
    start(taken);
    toggle();
    EXPECT_EQ(state(), "");
    EXPECT_EQ(panels().toast.text,
              "The link can't listen on " + other.address() + ": Address already in use.");
}

}  // namespace
}  // namespace kerf::app
