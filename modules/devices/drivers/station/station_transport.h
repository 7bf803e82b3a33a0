// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/drivers/station/station_address.h"
#include "station/stream/frame_stream.h"

#include <memory>

namespace chiron::devices {

/// One way in which frames reach a station. The thread that uses it is its only one: it owns the handle.
/// Everything but the two constructors' functions waits at most until the deadline it is given
/// (station::steadyNow_ns()).
class IStationTransport {
public:
    IStationTransport() = default;
    IStationTransport(const IStationTransport&) = delete;
    IStationTransport& operator=(const IStationTransport&) = delete;
    virtual ~IStationTransport() = default; ///< closes

    /// Sends an output frame, or drops it if the station does not take what came before: the newest wins, and
    /// nothing queues up.
    virtual station::Sent send(const station::FrameBytes& frame) noexcept = 0;
    /// Takes the oldest frame that was not taken yet. To have the newest, call it until it returns `nothing`.
    virtual station::Received receive(station::FrameBytes& frame, std::int64_t deadline_ns) noexcept = 0;
    /// Asks for a feature page, and gives the reply's frame, not checked; or, if none came, the last frame
    /// that came instead. Input frames that come meanwhile are lost.
    station::Received exchangeFeature(const station::FrameBytes& request, station::FrameBytes& reply,
                                      std::int64_t deadline_ns) noexcept;
    virtual void close() noexcept = 0;
    /// Frames or parts of frames whose framing was broken.
    virtual std::uint64_t malformed() const noexcept = 0;
};

/// Opens the line to a station: connects, or opens the device's file. Blocks for at most some seconds.
/// Errors: device, saying what was not found or not permitted, and what to do.
core::Result<std::unique_ptr<IStationTransport>> connectStation(const StationAddress& address);

} // namespace chiron::devices
