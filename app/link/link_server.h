#pragma once

#include <netinet/in.h>

#include <list>

#include "app/files/io/system_file.h"
#include "app/link/igtl_message.h"

namespace kerf::app {

/// Reads "[ADDRESS:]PORT", by default of this machine alone; 0 is a free port. None if it is
/// something else than an IPv4 address.
std::optional<sockaddr_in> readLinkAddress(const std::string& text);

/// A server of OpenIGTLink. It has no thread: bytes move only in its calls, and no call waits for a
/// client. What a client is slow to take is bounded, and dropped beyond that.
class LinkServer {
  public:
    /// Listens. Throws InputError if it can't there.
    explicit LinkServer(sockaddr_in address);
    /// Sends what waits, for a second at most, and disconnects the clients.
    ~LinkServer();
    LinkServer(const LinkServer&) = delete;
    LinkServer& operator=(const LinkServer&) = delete;

    /// "127.0.0.1:18944", with the port that it has.
    const std::string& address() const { return address_; }
    std::size_t clients() const { return clients_.size(); }
    /// How many have joined so far.
    int joined() const { return joined_; }

    /// What a message is given to; it throws InputError for one that nobody should have sent.
    using Take = std::function<void(const IgtlMessage& message)>;
    /// Lets clients join, sends and receives, for so many seconds; with 0 what can be done at once.
    /// A client whose bytes are no message, or one that `take` throws for, is disconnected.
    void exchange(double seconds, const Take& take);
    /// Sends a message to each client. With `replaceable` a client gets the latest one alone if it
    /// is behind.
    void send(const IgtlMessage& message, bool replaceable = false);

  private:
    /// Someone who has joined.
    struct Client {
        Client(int number, std::string whose) : socket(number), name(std::move(whose)) {}
        Descriptor socket;
        std::string name;
        IgtlReader reader;
        std::string unsent;
        std::string latest;  ///< replaceable, to be sent behind that
        int dropped = 0;     ///< messages that it was too slow for
        bool gone = false;
    };

    void await(double seconds) const;
    void accept();
    static void receive(Client& client, const Take& take);
    static void flush(Client& client);
    static void disconnect(Client& client, const std::string& reason);
    void dropGone();

    Descriptor listening_;
    std::string address_;
    int joined_ = 0;
    std::list<Client> clients_;
};

}  // namespace kerf::app
