// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/station_run.h"

#include <algorithm>

namespace chiron::station {

namespace {

constexpr std::int64_t kTick_ns = 1'000'000;
/// How often a stepped station looks whether it is to end, or whether a host waits.
constexpr std::int64_t kLook_ns = 20 * kTick_ns;

/// What both ways of running share: a host that comes and goes, frames that leave.
class Session {
public:
    Session(EmulatedStation& station, HostLine& line, const RunLimits& limits)
        : m_station(station), m_line(line), m_limits(limits) {}

    bool over(const std::atomic<bool>& stop) const {
        return stop.load(std::memory_order_relaxed) || (m_limits.untilHostGone && m_hostGone) ||
               (m_limits.ticks > 0 && m_station.totals().ticks >= m_limits.ticks);
    }
    /// Unplugs, plugs in again and lets a host in, as it is time.
    core::Result<void> tend() {
        if (m_station.unplugged() != m_unplugged) {
            m_unplugged = !m_unplugged;
            m_station.lineChanged();
            if (m_unplugged)
                m_line.unplug();
            else
                CHIRON_TRY(m_line.plug());
        }
        if (!m_unplugged && m_line.admitHost())
            m_station.lineChanged();
        return {};
    }
    void hostGone() {
        m_line.hostGone();
        m_station.lineChanged();
        m_hostGone = m_station.totals().applied > 0;
    }
    void sendAll() {
        FrameBytes frame{};
        while (m_station.nextToSend(frame))
            send(frame);
    }
    void send(const FrameBytes& frame) {
        if (m_line.connected() && m_line.stream().send(frame) == Sent::gone)
            hostGone();
    }
    void countBroken() {
        for (; m_broken < m_line.stream().malformed(); ++m_broken)
            m_station.brokenBlock();
        m_broken = m_line.stream().malformed(); // a new line begins anew
    }

private:
    EmulatedStation& m_station;
    HostLine& m_line;
    RunLimits m_limits;
    bool m_unplugged = false;
    bool m_hostGone = false;
    std::uint64_t m_broken = 0;
};

void append(std::string& json, const char* name, std::uint64_t value) {
    json += (json.size() > 1 ? ", \"" : "\"") + std::string(name) + "\": " + std::to_string(value);
}

} // namespace

core::Result<void> runByClock(EmulatedStation& station, HostLine& line, const RunLimits& limits,
                              const std::atomic<bool>& stop) {
    Session session(station, line, limits);
    std::int64_t next_ns = steadyNow_ns() + kTick_ns;
    while (!session.over(stop)) {
        CHIRON_TRY(session.tend());
        FrameBytes frame{};
        // Frames until the tick; a station that hangs takes none, and finds the old ones when it wakes up.
        while (steadyNow_ns() < next_ns) {
            if (!line.connected() || station.frozen()) {
                const std::int64_t left_ns = next_ns - steadyNow_ns();
                const timespec rest{0, std::clamp<long>(left_ns, 0, kTick_ns)};
                (void)::clock_nanosleep(CLOCK_MONOTONIC, 0, &rest, nullptr);
                break;
            }
            const Received got = line.stream().receive(frame, next_ns);
            if (got == Received::gone)
                session.hostGone();
            if (got != Received::frame)
                break;
            const std::int64_t into_ns = steadyNow_ns() - (next_ns - kTick_ns);
            (void)station.receive(
                frame, static_cast<std::uint32_t>(std::clamp<std::int64_t>(into_ns, 0, kTick_ns - 1) / 1000));
            session.sendAll(); // a reply
        }
        session.countBroken();
        while (steadyNow_ns() >= next_ns && !session.over(stop)) {
            station.tick();
            next_ns += kTick_ns;
            session.sendAll();
        }
    }
    return {};
}

core::Result<void> runLockstep(EmulatedStation& station, HostLine& line, const RunLimits& limits,
                               const std::atomic<bool>& stop) {
    Session session(station, line, limits);
    while (!session.over(stop)) {
        CHIRON_TRY(session.tend());
        if (!line.connected()) {
            const timespec rest{0, kTick_ns};
            (void)::clock_nanosleep(CLOCK_MONOTONIC, 0, &rest, nullptr);
            if (station.unplugged())
                station.tick(); // nobody steps a station without a line
            continue;
        }
        FrameBytes frame{};
        const Received got = line.stream().receive(frame, steadyNow_ns() + kLook_ns);
        session.countBroken();
        if (got == Received::gone)
            session.hostGone();
        if (got != Received::frame)
            continue;
        const bool steps = station.receive(frame, 0);
        if (steps)
            station.tick();
        session.sendAll();
        if (steps)
            session.send(station.endOfStep());
    }
    return {};
}

std::string totalsJson(const StationTotals& totals, std::size_t axes) {
    std::string json = "{";
    append(json, "ticks", totals.ticks);
    append(json, "applied", totals.applied);
    append(json, "watchdog_trips", totals.counters.watchdog_trips);
    append(json, "faults", totals.counters.faults);
    append(json, "bad_crc", totals.counters.bad_crc);
    append(json, "bad_frames", totals.counters.bad_frames);
    append(json, "lost_outputs", totals.counters.lost_outputs);
    append(json, "stale_outputs", totals.counters.stale_outputs);
    append(json, "last_output_us", totals.lastOutput_us);
    append(json, "last_force_us", totals.lastForce_us);
    append(json, "largest_display_mN", static_cast<std::uint64_t>(1e3 * totals.largestDisplay_N + 0.5));
    json += ", \"largest_effort_micro\": [";
    for (std::size_t axis = 0; axis < axes; ++axis)
        json += (axis > 0 ? ", " : "") + std::to_string(totals.largestEffort[axis]);
    return json + "]}";
}

} // namespace chiron::station
