#include "app/link/link_server.h"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <sys/socket.h>

#include <charconv>
#include <cstring>

#include "app/files/io/errors.h"
#include "sim/base/stopwatch.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr std::size_t kMostClients = 8;
constexpr std::size_t kMostUnsent = 64u << 20;  // to a client, before the latest body [bytes]
constexpr double kFinishing = 0.01;             // from one look at what is left to the next [s]
constexpr int kInTransit = 1 << 18;             // at the system, so that no old body waits [bytes]
constexpr double kLastWords = 1;                // for what clients are still to be sent [s]
constexpr double kLongestWait = 0.5;            // at a time [s]

std::string nameOf(const sockaddr_in& there) {
    std::array<char, INET_ADDRSTRLEN> host{};
    inet_ntop(AF_INET, &there.sin_addr, host.data(), host.size());
    return fmt::format("{}:{}", host.data(), ntohs(there.sin_port));
}

/// Of a call that did nothing now, but may later.
bool mayComeLater() {
    return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

}  // namespace

std::optional<sockaddr_in> readLinkAddress(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    const bool isNamed = colon != std::string::npos;
    const std::string host = isNamed ? text.substr(0, colon) : "127.0.0.1";
    const char* const end = text.data() + text.size();
    std::uint16_t port = 0;
    const auto read = std::from_chars(text.data() + (isNamed ? colon + 1 : 0), end, port);
    sockaddr_in address{AF_INET, htons(port), {}, {}};
    const bool isOne = read.ec == std::errc{} && read.ptr == end &&
                       inet_pton(AF_INET, host.c_str(), &address.sin_addr) == 1;
    return isOne ? std::optional(address) : std::nullopt;
}

LinkServer::LinkServer(sockaddr_in address)
    : listening_(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
    socklen_t size = sizeof(address);
    auto* const there = reinterpret_cast<sockaddr*>(&address);
    const int on = 1;
    ::setsockopt(listening_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
    if (::bind(listening_.get(), there, size) != 0 ||
        ::listen(listening_.get(), static_cast<int>(kMostClients)) != 0 ||
        ::getsockname(listening_.get(), there, &size) != 0) {
        throw InputError(
            fmt::format("The link can't listen on {}: {}.", nameOf(address), std::strerror(errno)));
    }
    address_ = nameOf(address);
    spdlog::info("Link: waiting for a client on {}.", address_);
    if (!address_.starts_with("127.")) {
        spdlog::warn("Link: whoever reaches this machine can lead the blade, without a password.");
    }
}

void LinkServer::exchange(double seconds, const Take& take) {
    const Stopwatch watch;
    do {
        await(seconds - watch.seconds());
        accept();
        for (Client& client : clients_) {
            receive(client, take);
            flush(client);
        }
        dropGone();
    } while (watch.seconds() < seconds);
}

/// Until something may be done.
void LinkServer::await(double seconds) const {
    std::vector<pollfd> sockets{{listening_.get(), POLLIN, 0}};
    for (const Client& client : clients_) {
        const int events = POLLIN | (client.unsent.empty() ? 0 : POLLOUT);
        sockets.push_back({client.socket.get(), static_cast<short>(events), 0});
    }
    const timespec longest{0, static_cast<long>(1e9 * std::clamp(seconds, 0.0, kLongestWait))};
    ::ppoll(sockets.data(), sockets.size(), &longest, nullptr);
}

void LinkServer::accept() {
    sockaddr_in from{};
    socklen_t size = sizeof(from);
    const int socket = ::accept4(listening_.get(), reinterpret_cast<sockaddr*>(&from), &size,
                                 SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (socket < 0) {
        return;
    }
    Client& client = clients_.emplace_back(socket, nameOf(from));
    if (clients_.size() > kMostClients) {
        disconnect(client, "there are as many clients as there may be.");
        return;
    }
    const int on = 1;
    ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
    ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &kInTransit, sizeof(kInTransit));
    spdlog::info("Link: {} has joined.", client.name);
    ++joined_;
}

void LinkServer::receive(Client& client, const Take& take) {
    std::array<char, 1u << 16> bytes;
    const ssize_t count = ::recv(client.socket.get(), bytes.data(), bytes.size(), 0);
    if (client.gone || count == 0 || (count < 0 && !mayComeLater())) {
        disconnect(client, "it has left.");
        return;
    }
    try {
        client.reader.add({bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count))});
        while (const auto message = client.reader.next()) {
            take(*message);
        }
    } catch (const InputError& error) {
        disconnect(client, error.what());
    }
}

void LinkServer::send(const IgtlMessage& message, bool replaceable) {
    const std::string bytes = clients_.empty() ? "" : packIgtl(message);
    for (Client& client : clients_) {
        if (replaceable && !client.unsent.empty()) {
            client.dropped += client.latest.empty() ? 0 : 1;
            client.latest = bytes;
        } else if (client.unsent.size() < kMostUnsent) {
            client.unsent += bytes;
        } else {
            ++client.dropped;
        }
        flush(client);
    }
    dropGone();
}

LinkServer::~LinkServer() {
    const Stopwatch watch;
    const auto waits = [](const Client& client) { return !client.unsent.empty(); };
    while (std::ranges::any_of(clients_, waits) && watch.seconds() < kLastWords) {
        exchange(kFinishing, [](const IgtlMessage&) {});
    }
    for (Client& client : clients_) {
        disconnect(client, "the session is over.");
    }
}

void LinkServer::flush(Client& client) {
    if (client.unsent.empty()) {
        client.unsent = std::exchange(client.latest, {});
    }
    const ssize_t count =
        ::send(client.socket.get(), client.unsent.data(), client.unsent.size(), MSG_NOSIGNAL);
    if (count < 0 && !mayComeLater()) {
        disconnect(client, "it has left.");
    }
    client.unsent.erase(0, static_cast<std::size_t>(std::max<ssize_t>(0, count)));
}

/// Says so once.
void LinkServer::disconnect(Client& client, const std::string& reason) {
    if (!std::exchange(client.gone, true)) {
        client.dropped += (client.unsent.empty() ? 0 : 1) + (client.latest.empty() ? 0 : 1);
        spdlog::info("Link: {} is disconnected: {} {} dropped, as it was too slow.", client.name,
                     reason, counted(client.dropped, "message was", "messages were"));
    }
}

void LinkServer::dropGone() {
    std::erase_if(clients_, [](const Client& client) { return client.gone; });
}

}  // namespace kerf::app
