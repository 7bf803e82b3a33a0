// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/host_line.h"

#include <arpa/inet.h>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

namespace chiron::station {

namespace {
tl::unexpected<core::Error> failed(const std::string& what) {
    return core::fail(core::ErrorCode::device, what + ": " + std::strerror(errno));
}

void closeIt(int& descriptor) noexcept {
    if (descriptor >= 0)
        ::close(descriptor);
    descriptor = -1;
}
} // namespace

HostLine::~HostLine() {
    unplug();
    if (!m_link.empty())
        ::unlink(m_link.c_str());
}

core::Result<void> HostLine::listenTcp(const std::string& host, std::uint16_t port) {
    m_host = host;
    m_port = port;
    return listen();
}

core::Result<void> HostLine::listen() {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(m_port);
    if (::inet_pton(AF_INET, m_host.c_str(), &place.sin_addr) != 1)
        return core::fail(core::ErrorCode::badInput,
                          "address " + m_host + ": expected numbers, as 127.0.0.1 or 0.0.0.0");
    m_listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const int on = 1;
    if (m_listener < 0 || ::setsockopt(m_listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0 ||
        ::bind(m_listener, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 ||
        ::listen(m_listener, 4) != 0) {
        auto error = failed("port " + std::to_string(m_port));
        closeIt(m_listener);
        return error;
    }
    socklen_t size = sizeof place;
    if (::getsockname(m_listener, reinterpret_cast<sockaddr*>(&place), &size) == 0)
        m_port = ntohs(place.sin_port);
    return {};
}

core::Result<void> HostLine::openHidraw(const std::string& folder, const std::string& serialNumber) {
    m_kind = Kind::hidraw;
    m_serialNumber = serialNumber;
    auto node = HidrawNode::serve(folder);
    CHIRON_TRY(node);
    m_node = *std::move(node);
    return plug();
}

core::Result<void> HostLine::openTerminal(const std::string& link) {
    m_kind = Kind::terminal;
    m_link = link;
    return openPair();
}

core::Result<void> HostLine::openPair() {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    char path[64];
    if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0 ||
        ::ptsname_r(master, path, sizeof path) != 0) {
        auto error = failed("pseudo-terminal");
        if (master >= 0)
            ::close(master);
        return error;
    }
    m_otherEnd = ::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios line{};
    if (m_otherEnd < 0 || ::tcgetattr(m_otherEnd, &line) != 0) {
        auto error = failed(path);
        ::close(master);
        closeIt(m_otherEnd);
        return error;
    }
    ::cfmakeraw(&line);
    (void)::tcsetattr(m_otherEnd, TCSANOW, &line);
    m_path = path;
    m_stream = FrameStream(master, Framing::cobs);
    if (m_link.empty())
        return {};
    ::unlink(m_link.c_str());
    if (::symlink(path, m_link.c_str()) != 0)
        return failed(m_link);
    return {};
}

std::string HostLine::address() const {
    switch (m_kind) {
    case Kind::terminal:
        return "serial:" + (m_link.empty() ? m_path : m_link);
    case Kind::hidraw: {
        char ids[16];
        (void)std::snprintf(ids, sizeof ids, "%04x:%04x", kTrialVendor, kTrialProduct);
        return std::string("hid:") + ids + ":" + m_serialNumber;
    }
    case Kind::tcp:
        break;
    }
    return "tcp:" + (m_host == "0.0.0.0" ? std::string("localhost") : m_host) + ":" + std::to_string(m_port);
}

bool HostLine::admitHost() {
    if (m_listener < 0)
        return false;
    const int host = ::accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (host < 0)
        return false;
    pollfd present{m_stream.descriptor(), POLLRDHUP, 0};
    if (m_stream.isOpen() && ::poll(&present, 1, 0) == 0) {
        ::close(host);
        return false;
    }
    const int on = 1;
    (void)::setsockopt(host, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    m_stream = FrameStream(host, Framing::concatenated);
    return true;
}

void HostLine::hostGone() noexcept {
    if (m_kind == Kind::tcp)
        m_stream.close();
}

void HostLine::unplug() noexcept {
    m_stream.close();
    closeIt(m_listener);
    closeIt(m_otherEnd);
    if (m_node)
        m_node->unplug();
}

core::Result<void> HostLine::plug() {
    switch (m_kind) {
    case Kind::terminal:
        return openPair();
    case Kind::hidraw:
        m_stream = m_node->plugIn();
        return m_stream.isOpen() ? core::Result<void>() : failed("a line to the node");
    case Kind::tcp:
        break;
    }
    return listen();
}

} // namespace chiron::station
