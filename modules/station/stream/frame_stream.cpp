// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/stream/frame_stream.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <linux/sockios.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace chiron::station {

namespace {
constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr int kReads = 16; ///< between two looks at the clock while bytes keep coming

/// Bytes that were written and that the other side has not taken; 0 where the line cannot tell.
int unsent(int descriptor, bool socket) noexcept {
    int waiting = 0;
    const unsigned long question = socket ? SIOCOUTQ : TIOCOUTQ;
    return ::ioctl(descriptor, question, &waiting) == 0 ? waiting : 0;
}
} // namespace

std::int64_t steadyNow_ns() noexcept {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::int64_t>(now.tv_sec) * kSecond_ns + now.tv_nsec;
}

FrameStream::FrameStream(int descriptor, Framing framing) noexcept
    : m_descriptor(descriptor), m_framing(framing) {
    struct stat about {};
    m_socket = ::fstat(descriptor, &about) == 0 && S_ISSOCK(about.st_mode);
    const int flags = ::fcntl(descriptor, F_GETFL, 0);
    if (flags >= 0)
        (void)::fcntl(descriptor, F_SETFL, flags | O_NONBLOCK);
}

FrameStream::FrameStream(FrameStream&& other) noexcept {
    *this = std::move(other);
}

FrameStream& FrameStream::operator=(FrameStream&& other) noexcept {
    if (this == &other)
        return *this;
    close();
    m_descriptor = std::exchange(other.m_descriptor, -1);
    m_framing = other.m_framing;
    m_socket = other.m_socket;
    m_begun = other.m_begun;
    m_decoder = other.m_decoder;
    m_malformed = other.m_malformed;
    m_begin = other.m_begin;
    m_end = other.m_end;
    m_restBegin = other.m_restBegin;
    m_restEnd = other.m_restEnd;
    m_rest = other.m_rest;
    m_in = other.m_in;
    return *this;
}

FrameStream::~FrameStream() {
    close();
}

void FrameStream::close() noexcept {
    if (m_descriptor >= 0)
        ::close(m_descriptor);
    m_descriptor = -1;
    m_begin = m_end = m_restBegin = m_restEnd = 0;
    m_begun = false;
    station_cobs_begin(&m_decoder);
}

long FrameStream::writeSome(const std::uint8_t* bytes, std::size_t count) noexcept {
    for (;;) {
        const ssize_t written = m_socket ? ::send(m_descriptor, bytes, count, MSG_NOSIGNAL | MSG_DONTWAIT)
                                         : ::write(m_descriptor, bytes, count);
        if (written >= 0)
            return static_cast<long>(written);
        if (errno == EINTR)
            continue;
        return errno == EAGAIN || errno == EWOULDBLOCK ? 0 : -1;
    }
}

/// Writes what is left of a frame; false if the connection is gone.
bool FrameStream::flushRest() noexcept {
    while (m_restBegin < m_restEnd) {
        const long written = writeSome(m_rest.data() + m_restBegin, m_restEnd - m_restBegin);
        if (written < 0)
            return false;
        if (written == 0)
            return true;
        m_restBegin += static_cast<std::size_t>(written);
    }
    return true;
}

Sent FrameStream::send(const FrameBytes& frame) noexcept {
    if (m_descriptor < 0 || !flushRest())
        return Sent::gone;
    if (m_restBegin < m_restEnd || unsent(m_descriptor, m_socket) > kMostUnsent_bytes)
        return Sent::dropped;
    m_restEnd = 0;
    if (m_framing == Framing::cobs) {
        if (!m_begun)
            m_rest[m_restEnd++] = 0; // ends whatever a sender before us left unfinished
        station_cobs_encode(frame.data(), m_rest.data() + m_restEnd);
        m_restEnd += STATION_COBS_SIZE;
    } else {
        std::copy(frame.begin(), frame.end(), m_rest.begin());
        m_restEnd = frame.size();
    }
    m_restBegin = 0;
    const long written = writeSome(m_rest.data(), m_restEnd);
    if (written < 0)
        return Sent::gone;
    if (written == 0) {
        m_restEnd = 0;
        return Sent::dropped;
    }
    m_begun = true;
    m_restBegin = static_cast<std::size_t>(written);
    return Sent::sent; // a rest is written before the next frame
}

void FrameStream::forget(std::size_t bytes) noexcept {
    m_begin += bytes;
    if (m_begin == m_end)
        m_begin = m_end = 0;
}

bool FrameStream::takeConcatenated(FrameBytes& frame) noexcept {
    if (m_end - m_begin < kFrameBytes)
        return false;
    std::memcpy(frame.data(), m_in.data() + m_begin, kFrameBytes);
    forget(kFrameBytes);
    return true;
}

bool FrameStream::takeCobs(FrameBytes& frame) noexcept {
    while (m_begin < m_end) {
        const std::uint8_t byte = m_in[m_begin];
        forget(1);
        switch (station_cobs_take(&m_decoder, byte, frame.data())) {
        case STATION_COBS_FRAME:
            return true;
        case STATION_COBS_BROKEN:
            ++m_malformed;
            break;
        case STATION_COBS_NOTHING:
            break;
        }
    }
    return false;
}

bool FrameStream::takeBuffered(FrameBytes& frame) noexcept {
    return m_framing == Framing::cobs ? takeCobs(frame) : takeConcatenated(frame);
}

Received FrameStream::receive(FrameBytes& frame, std::int64_t deadline_ns) noexcept {
    int reads = 0;
    for (;;) {
        if (m_descriptor < 0)
            return Received::gone;
        if (takeBuffered(frame))
            return Received::frame;
        if (m_begin > 0) {
            std::memmove(m_in.data(), m_in.data() + m_begin, m_end - m_begin);
            m_end -= m_begin;
            m_begin = 0;
        }
        const ssize_t got = ::read(m_descriptor, m_in.data() + m_end, m_in.size() - m_end);
        if (got > 0) {
            m_end += static_cast<std::size_t>(got);
            // Who sends without end, and no frame, does not hold the caller.
            if (++reads % kReads != 0 || steadyNow_ns() < deadline_ns)
                continue;
            return takeBuffered(frame) ? Received::frame : Received::nothing;
        }
        if (got == 0)
            return Received::gone;
        if (errno == EINTR)
            continue;
        if (errno != EAGAIN && errno != EWOULDBLOCK)
            return Received::gone;
        const std::int64_t left_ns = deadline_ns - steadyNow_ns();
        if (left_ns <= 0)
            return Received::nothing;
        pollfd waited{m_descriptor, POLLIN, 0};
        const timespec atMost{static_cast<std::time_t>(left_ns / kSecond_ns),
                              static_cast<long>(left_ns % kSecond_ns)};
        (void)::ppoll(&waited, 1, &atMost, nullptr);
    }
}

} // namespace chiron::station
