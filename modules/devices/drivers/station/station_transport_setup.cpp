// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/station_transport.h"

#include "devices/drivers/station/hid_transport.h"
#include "devices/drivers/station/stream_transport.h"
#include "station/protocol/station_frame.h"

namespace chiron::devices {

station::Received IStationTransport::exchangeFeature(const station::FrameBytes& request,
                                                     station::FrameBytes& reply,
                                                     std::int64_t deadline_ns) noexcept {
    if (send(request) == station::Sent::gone)
        return station::Received::gone;
    bool heard = false;
    station::FrameBytes frame{};
    for (;;) {
        const station::Received got = receive(frame, deadline_ns);
        if (got == station::Received::gone)
            return got;
        if (got == station::Received::frame) {
            heard = true;
            reply = frame;
            if (frame[0] == STATION_FEATURE_REPLY && frame[1] == request[1])
                return got;
        }
        // Whoever asked can tell something else from nothing.
        if (got == station::Received::nothing || station::steadyNow_ns() >= deadline_ns)
            return heard ? station::Received::frame : station::Received::nothing;
    }
}

core::Result<std::unique_ptr<IStationTransport>> connectStation(const StationAddress& address) {
    switch (address.kind) {
    case StationAddress::Kind::tcp:
        return connectTcp(address.host, address.port);
    case StationAddress::Kind::serial:
        return openSerial(address.path);
    case StationAddress::Kind::hid:
        break;
    }
    return openHid(address);
}

} // namespace chiron::devices
