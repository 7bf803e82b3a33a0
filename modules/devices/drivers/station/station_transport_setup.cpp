// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/station_transport.h"

#include "devices/drivers/station/stream_transport.h"

namespace chiron::devices {

core::Result<std::unique_ptr<IStationTransport>> connectStation(const StationAddress& address) {
    switch (address.kind) {
    case StationAddress::Kind::tcp:
        return connectTcp(address.host, address.port);
    case StationAddress::Kind::serial:
        break;
    }
    return openSerial(address.path);
}

} // namespace chiron::devices
