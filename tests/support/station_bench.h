// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/station/emulated_station.h"
#include "app/station/holding_hand.h"
#include "app/station/host_line.h"
#include "app/station/station_run.h"
#include "devices/driver_catalogue.h"
#include "support/hid_computer.h"

#include <QtTest>
#include <atomic>
#include <memory>
#include <string>
#include <thread>

namespace chiron::tests {

/// The wire over which a station is reached. hid: only within HidComputer.
enum class Wire { tcp, terminal, hid };
inline const char* nameOf(Wire wire) {
    return wire == Wire::tcp ? "tcp" : wire == Wire::terminal ? "terminal" : "hid";
}

/// An emulated station on a thread of its own, and where it is reached.
class StationBench {
public:
    explicit StationBench(station::EmulatedStation::Configuration configuration, Wire wire = Wire::tcp)
        : m_lockstep(configuration.lockstep), m_wire(wire) {
        const std::string serialNumber = configuration.serialNumber;
        auto made = station::EmulatedStation::create(std::move(configuration));
        if (!made)
            qFatal("%s", made.error().message.c_str());
        m_station = std::move(*made);
        const auto open = wire == Wire::tcp        ? m_line.listenTcp("127.0.0.1", 0)
                          : wire == Wire::terminal ? m_line.openTerminal(std::string())
                                                   : m_line.openHidraw(HidComputer::kFolder, serialNumber);
        if (!open)
            qFatal("%s", open.error().message.c_str());
        if (wire == Wire::hid)
            HidComputer::plugIn(0, serialNumber);
        address = m_line.address();
        m_thread = std::thread([this] {
            result = m_lockstep ? station::runLockstep(*m_station, m_line, {}, m_stop)
                                : station::runByClock(*m_station, m_line, {}, m_stop);
        });
    }
    ~StationBench() {
        (void)stop();
        if (m_wire == Wire::hid)
            HidComputer::pullOut(0);
    }

    /// Ends it and says what it did.
    station::StationTotals stop() {
        m_stop.store(true);
        if (m_thread.joinable())
            m_thread.join();
        m_line.unplug();
        return m_station->totals();
    }
    const station::EmulatedStation& emulated() const { return *m_station; }

    std::string address;
    core::Result<void> result;

private:
    bool m_lockstep;
    Wire m_wire;
    std::unique_ptr<station::EmulatedStation> m_station;
    station::HostLine m_line;
    std::atomic<bool> m_stop{false};
    std::thread m_thread;
};

inline station::EmulatedStation::Configuration stationOn(const std::string& mechanism) {
    station::EmulatedStation::Configuration configuration;
    configuration.mechanism = mechanism;
    configuration.strategy =
        std::make_unique<station::HoldingHand>(station::HoldingHand::Motion{.amplitude_m = 0.003});
    return configuration;
}

/// The same in a hand that begins to press on the bench's ball after this time.
inline station::EmulatedStation::Configuration pressingStation(double after_s = 3.0) {
    station::EmulatedStation::Configuration configuration = stationOn("gimbal_hprd");
    configuration.strategy = std::make_unique<station::HoldingHand>(
        station::HoldingHand::Motion{.depth_m = 0.040, .after_s = after_s});
    configuration.lockstep = true;
    return configuration;
}

/// Opens the tool of the station driver at this address.
inline core::Result<std::vector<devices::DriverTool>> toolAt(const std::string& address) {
    devices::DriverRequest request;
    request.tools.emplace_back();
    request.tools.front().address = address;
    return devices::findDriver("station")->open(std::move(request));
}

} // namespace chiron::tests
