// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "station/protocol/station_cobs.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace chiron::station {

inline constexpr std::size_t kFrameBytes = STATION_FRAME_SIZE;
/// One frame of the station protocol as it travels (docs/station-protocol.md).
using FrameBytes = std::array<std::uint8_t, kFrameBytes>;

/// How frames follow each other in a stream of bytes.
enum class Framing {
    concatenated, ///< one after the other, as over TCP, which loses no byte
    cobs, ///< COBS with a zero byte between two frames, as over a serial line: finds the next frame again
};

enum class Received {
    frame,   ///< a frame was taken
    nothing, ///< none came in time
    gone,    ///< the other side has closed the connection, or the line is gone
};

enum class Sent {
    sent,
    dropped, ///< the other side does not take what was sent before; the newest frame is never queued behind
             ///< it
    gone,
};

/// Nanoseconds of CLOCK_MONOTONIC.
std::int64_t steadyNow_ns() noexcept;

/// Frames of 64 bytes over a file descriptor: a TCP socket, a serial line, a pseudo-terminal. It owns the
/// descriptor. It never waits for the other side to take a frame, and keeps at most kMostUnsent_bytes on the
/// way: what the other side does not take in time is dropped, never queued.
/// Thread: one. Allocates nothing.
class FrameStream {
public:
    static constexpr int kMostUnsent_bytes = 16 * static_cast<int>(kFrameBytes);

    FrameStream() noexcept = default;
    /// Takes over an open descriptor and makes it non-blocking.
    FrameStream(int descriptor, Framing framing) noexcept;
    FrameStream(FrameStream&& other) noexcept;
    FrameStream& operator=(FrameStream&& other) noexcept;
    ~FrameStream();

    bool isOpen() const noexcept { return m_descriptor >= 0; }
    int descriptor() const noexcept { return m_descriptor; }
    void close() noexcept;

    Sent send(const FrameBytes& frame) noexcept;
    /// Takes the oldest frame that has come and was not taken yet; waits for one until `deadline_ns`
    /// (steadyNow_ns(); a time in the past: does not wait).
    Received receive(FrameBytes& frame, std::int64_t deadline_ns) noexcept;
    /// Frames or parts of frames that had no valid framing (COBS).
    std::uint64_t malformed() const noexcept { return m_malformed; }

private:
    static constexpr std::size_t kRoom_bytes = 8192;
    /// A frame by COBS, and the zero that begins a line.
    static constexpr std::size_t kMostWritten_bytes = STATION_COBS_SIZE + 1;

    bool takeBuffered(FrameBytes& frame) noexcept;
    bool takeConcatenated(FrameBytes& frame) noexcept;
    bool takeCobs(FrameBytes& frame) noexcept;
    void forget(std::size_t bytes) noexcept;
    bool flushRest() noexcept;
    long writeSome(const std::uint8_t* bytes, std::size_t count) noexcept;

    int m_descriptor = -1;
    Framing m_framing = Framing::concatenated;
    bool m_socket = false;
    bool m_begun = false; ///< something was written: the line is in step
    std::uint64_t m_malformed = 0;
    std::size_t m_begin = 0; ///< of what was read and not taken, in m_in
    std::size_t m_end = 0;
    std::size_t m_restBegin = 0; ///< rest of a frame that was only partly written
    std::size_t m_restEnd = 0;
    station_cobs m_decoder{};
    std::array<std::uint8_t, kMostWritten_bytes> m_rest{};
    std::array<std::uint8_t, kRoom_bytes> m_in{};
};

} // namespace chiron::station
