// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/drivers/station/station_handshake.h"
#include "devices/drivers/station/station_health.h"
#include "devices/drivers/station/station_transport.h"
#include "realtime/latest_value.h"
#include "station/protocol/station_frame.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace chiron::devices {

/// The newest input of a station, with numbers that do not wrap.
struct LinkInput {
    station_input input{};
    std::uint32_t packet = 0;        ///< 0: nothing has come yet
    std::uint64_t deviceTime_us = 0; ///< goes on when the station's clock wraps or starts again
    std::int64_t arrival_ns = 0;     ///< CLOCK_MONOTONIC
    bool gone = false;               ///< the link is gone, and nothing newer has come
};

/// The thread that owns a station's line while it is open: it takes every input frame as it comes, counts
/// what is missing or wrong, and sends each new output once. It repeats no output by itself, so that a loop
/// that has stopped lets the station let go. A line that is gone is opened again, about twice a second, and
/// used if the same station answers. Thread: newest() and put() on the haptic thread, where they neither wait
/// nor allocate; health() on one other; the rest where nothing of this runs.
class StationLink {
public:
    struct Settings {
        StationAddress address;
        std::string where; ///< for messages
        StationIdentity identity;
    };

    /// Starts the thread on a station that startStation() has prepared.
    StationLink(std::unique_ptr<IStationTransport> transport, Settings settings, const StationStart& start);
    StationLink(const StationLink&) = delete;
    StationLink& operator=(const StationLink&) = delete;
    ~StationLink(); ///< finish()

    /// Sends outputs that enable nothing until the station has applied one, for at most kFarewell_ns; then
    /// closes the line and ends the thread.
    void finish() noexcept;

    static constexpr std::int64_t kFarewell_ns = 50'000'000;

    const LinkInput& newest() noexcept { return m_input.latest(); }
    void put(const station_output& output) noexcept {
        m_output.publish(output);
        m_put.store(output.sequence, std::memory_order_release);
    }
    StationHealth health() noexcept { return m_health.latest(); }

    /// Of a stepped station: waits until it has finished the step of the last output. False if it does not
    /// within a second, or is gone. Not for the tick.
    bool awaitStep() noexcept;

private:
    void run() noexcept;
    void runConnected() noexcept;
    void runStepped() noexcept;
    bool sendNewest() noexcept;
    void takeAll(std::int64_t deadline_ns) noexcept;
    void take(const station::FrameBytes& bytes, std::int64_t arrival_ns) noexcept;
    void takeInput(const station_input& input, std::int64_t arrival_ns) noexcept;
    void noteRoundTrip(const station_input& input, std::int64_t arrival_ns) noexcept;
    void send(const station_output& output) noexcept;
    void lose() noexcept;
    bool reconnect();
    void sayFarewell() noexcept;
    void publishHealth() noexcept;

    std::unique_ptr<IStationTransport> m_transport;
    Settings m_settings;
    realtime::LatestValue<LinkInput> m_input;
    realtime::LatestValue<station_output> m_output;
    realtime::LatestValue<StationHealth> m_health;
    std::atomic<std::uint16_t> m_put;     ///< number of the last output
    std::atomic<std::uint16_t> m_stepped; ///< of the last output whose step is over
    std::mutex m_steps;                   ///< between awaitStep() and the thread alone
    std::condition_variable m_stepChanged;
    std::atomic<bool> m_gone{false};
    std::atomic<bool> m_stop{false};

    // Of the thread alone.
    LinkInput m_last;
    StationHealth m_counts;
    std::uint16_t m_sentSequence;
    std::uint64_t m_brokenBefore = 0; ///< malformed() of earlier transports of this link, already counted
    bool m_stepDone = false;          ///< the end of the stepped station's step has come
    std::uint16_t m_staleSequence = 0;
    std::uint32_t m_staleInRow = 0; ///< stale inputs whose numbers follow each other, with none between
    bool m_fresh = false;           ///< the line is new: the next input begins a new series of numbers
    std::int64_t m_nextHealth_ns = 0;
    std::array<std::int64_t, 256> m_sentAt_ns{}; ///< by number; 0: already answered
    static constexpr std::size_t kBins = 512;
    static constexpr std::int64_t kBin_ns = 50'000;
    std::array<std::uint32_t, kBins> m_roundTrips{}; ///< the last bin has all longer ones
    std::uint32_t m_roundTripCount = 0;
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace chiron::devices
