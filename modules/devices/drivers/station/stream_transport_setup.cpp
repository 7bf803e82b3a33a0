// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/stream_transport.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace chiron::devices {

namespace {

constexpr int kConnect_ms = 2000;
/// A line on which nothing is acknowledged for so long is gone, so that it is opened again.
constexpr unsigned kUnacknowledged_ms = 2000;

class StreamTransport final : public IStationTransport {
public:
    explicit StreamTransport(station::FrameStream stream) noexcept : m_stream(std::move(stream)) {}

    station::Sent send(const station::FrameBytes& frame) noexcept override { return m_stream.send(frame); }
    station::Received receive(station::FrameBytes& frame, std::int64_t deadline_ns) noexcept override {
        return m_stream.receive(frame, deadline_ns);
    }
    void close() noexcept override { m_stream.close(); }
    std::uint64_t malformed() const noexcept override { return m_stream.malformed(); }

private:
    station::FrameStream m_stream;
};

tl::unexpected<core::Error> unreachable(const std::string& host, std::uint16_t port, const std::string& why) {
    return core::fail(core::ErrorCode::device,
                      "station at " + host + ", port " + std::to_string(port) + ": " + why +
                          "; check that it is switched on and that address and port are right");
}

/// A connected socket, or -1 with errno.
int connectWithin(const addrinfo& place, int atMost_ms) {
    const int descriptor =
        ::socket(place.ai_family, place.ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, place.ai_protocol);
    if (descriptor < 0)
        return -1;
    int problem = 0;
    if (::connect(descriptor, place.ai_addr, place.ai_addrlen) != 0) {
        problem = errno;
        if (problem == EINPROGRESS) {
            pollfd waited{descriptor, POLLOUT, 0};
            socklen_t size = sizeof problem;
            if (::poll(&waited, 1, atMost_ms) <= 0)
                problem = ETIMEDOUT;
            else if (::getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &problem, &size) != 0)
                problem = errno;
        }
    }
    if (problem == 0)
        return descriptor;
    ::close(descriptor);
    errno = problem;
    return -1;
}

} // namespace

std::unique_ptr<IStationTransport> makeStreamTransport(station::FrameStream stream) {
    return std::make_unique<StreamTransport>(std::move(stream));
}

core::Result<std::unique_ptr<IStationTransport>> connectTcp(const std::string& host, std::uint16_t port) {
    addrinfo wanted{};
    wanted.ai_family = AF_UNSPEC;
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo* places = nullptr;
    if (const int problem = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &places);
        problem != 0)
        return unreachable(host, port, ::gai_strerror(problem));
    int descriptor = -1;
    int problem = ECONNREFUSED;
    for (const addrinfo* place = places; place != nullptr && descriptor < 0; place = place->ai_next) {
        descriptor = connectWithin(*place, kConnect_ms);
        problem = descriptor < 0 ? errno : 0;
    }
    ::freeaddrinfo(places);
    if (descriptor < 0)
        return unreachable(host, port, std::strerror(problem));
    const int on = 1;
    (void)::setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    (void)::setsockopt(descriptor, IPPROTO_TCP, TCP_USER_TIMEOUT, &kUnacknowledged_ms,
                       sizeof kUnacknowledged_ms);
    return makeStreamTransport({descriptor, station::Framing::concatenated});
}

core::Result<std::unique_ptr<IStationTransport>> openSerial(const std::string& path) {
    const auto refuse = [&path](const std::string& why) {
        return core::fail(core::ErrorCode::device, "station at " + path + ": " + why);
    };
    const int descriptor = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) {
        const int problem = errno;
        return refuse(std::string(std::strerror(problem)) +
                      (problem == EACCES
                           ? "; this person may not open it: become a member of the group that owns it "
                             "(on Debian: dialout) and log in again"
                           : "; check that the station is plugged in and switched on"));
    }
    termios line{};
    if (::tcgetattr(descriptor, &line) != 0) {
        ::close(descriptor);
        return refuse("it is no serial line");
    }
    ::cfmakeraw(&line);
    line.c_cflag |= CLOCAL | CREAD;
    line.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
    line.c_cc[VMIN] = 1; // an empty line is told from one that has gone
    line.c_cc[VTIME] = 0;
    if (::cfsetspeed(&line, B1000000) != 0 || ::tcsetattr(descriptor, TCSANOW, &line) != 0) {
        const int problem = errno;
        ::close(descriptor);
        return refuse(std::string("1 Mbit/s cannot be set: ") + std::strerror(problem));
    }
    (void)::ioctl(descriptor, TIOCEXCL); // two programs on one line would take each other's frames
    (void)::tcflush(descriptor, TCIOFLUSH);
    return makeStreamTransport({descriptor, station::Framing::cobs});
}

} // namespace chiron::devices
