// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/station_link.h"

#include "realtime/realtime_thread.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <pthread.h>
#include <span>
#include <utility>

namespace chiron::devices {

namespace {
constexpr std::int64_t kMicrosecond_ns = 1'000;
constexpr std::int64_t kMillisecond_ns = 1'000'000;
/// How often the thread looks for a new output while no input comes: a part of the round trip.
constexpr std::int64_t kLook_ns = 100 * kMicrosecond_ns;
constexpr std::int64_t kHealth_ns = 100 * kMillisecond_ns;
constexpr std::int64_t kRetry_ns = 500 * kMillisecond_ns;
constexpr std::uint32_t kStartedAgain = 20; ///< frames
/// Frames that are taken before the newest is handed on and a command is sent: no station sends so many in
/// time, and one that never stops must not hold the line.
constexpr int kMostAtOnce = 512;
constexpr std::int64_t kStep_ns = 1000 * kMillisecond_ns; ///< longest wait for a stepped station
/// Its work is short, and the tick waits for what it brings.
constexpr int kLinkPriority = realtime::kHapticPriority + 1;

void sleep(std::int64_t duration_ns) noexcept {
    const timespec duration{static_cast<std::time_t>(duration_ns / 1'000'000'000),
                            static_cast<long>(duration_ns % 1'000'000'000)};
    (void)::clock_nanosleep(CLOCK_MONOTONIC, 0, &duration, nullptr);
}

/// The time, in bins of `bin_ns`, that this share of `count` round trips did not exceed.
std::uint32_t percentile_us(std::span<const std::uint32_t> bins, std::uint32_t count, double share,
                            std::int64_t bin_ns) noexcept {
    auto left = static_cast<std::uint64_t>(share * count);
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
        if (left < bins[bin])
            return static_cast<std::uint32_t>(static_cast<std::int64_t>(bin + 1) * bin_ns / kMicrosecond_ns);
        left -= bins[bin];
    }
    return 0; // nothing was counted
}
} // namespace

StationLink::StationLink(std::unique_ptr<IStationTransport> transport, Settings settings,
                         const StationStart& start)
    : m_transport(std::move(transport)), m_settings(std::move(settings)), m_put(start.sequence),
      m_stepped(start.sequence), m_sentSequence(start.sequence) {
    m_last = {start.newest, 1, start.newest.time_us, start.arrival_ns, false};
    m_input.publish(m_last);
    m_counts.connected = true;
    m_counts.received = 1;
    m_health.publish(m_counts);
    station_output none{};
    none.sequence = start.sequence;
    m_output.publish(none);
    (void)m_output.latest(); // already sent
    m_thread = std::thread([this] { run(); });
}

StationLink::~StationLink() {
    finish();
}

void StationLink::finish() noexcept {
    m_stop.store(true, std::memory_order_release);
    if (m_thread.joinable())
        m_thread.join();
}

bool StationLink::awaitStep() noexcept {
    const std::uint16_t wanted = m_put.load(std::memory_order_relaxed);
    const auto stepped = [&] { return m_stepped.load(std::memory_order_acquire) == wanted; };
    std::unique_lock lock(m_steps);
    m_stepChanged.notify_all(); // the thread need not wait until it looks by itself
    return m_stepChanged.wait_for(lock, std::chrono::nanoseconds(kStep_ns), [&] {
        return stepped() || m_gone.load(std::memory_order_relaxed);
    }) && stepped();
}

void StationLink::run() noexcept {
    sigset_t all; // a signal would look like an unplugged device to hidapi
    ::sigfillset(&all);
    (void)::pthread_sigmask(SIG_BLOCK, &all, nullptr);
    (void)realtime::setUpRealtimeThread(kLinkPriority);
    while (!m_stop.load(std::memory_order_acquire)) {
        if (m_settings.identity.lockstep)
            runStepped();
        else
            runConnected();
        if (m_stop.load(std::memory_order_acquire))
            break;
        publishHealth();
        for (std::int64_t waited_ns = 0; waited_ns < kRetry_ns && !m_stop.load(std::memory_order_acquire);
             waited_ns += 10 * kMillisecond_ns)
            sleep(10 * kMillisecond_ns);
        if (!m_stop.load(std::memory_order_acquire) && reconnect())
            m_gone.store(false, std::memory_order_relaxed);
    }
    sayFarewell();
    publishHealth();
}

/// Until the line is gone or the link is to end.
void StationLink::runConnected() noexcept {
    while (m_transport && !m_stop.load(std::memory_order_acquire)) {
        takeAll(station::steadyNow_ns() + kLook_ns);
        (void)sendNewest();
        if (station::steadyNow_ns() >= m_nextHealth_ns)
            publishHealth();
    }
}

/// The same with a station that sends nothing by itself: waits for a command, then for the end of its step.
void StationLink::runStepped() noexcept {
    bool open = false; // the step of the last command
    while (m_transport && !m_stop.load(std::memory_order_acquire)) {
        if (!open) {
            std::unique_lock lock(m_steps);
            (void)m_stepChanged.wait_for(lock, std::chrono::nanoseconds(kLook_ns), [this] {
                return m_put.load(std::memory_order_acquire) != m_sentSequence;
            });
        }
        open = sendNewest() || open;
        if (m_transport)
            takeAll(open ? station::steadyNow_ns() + kMillisecond_ns : 0);
        if (m_stepped.load(std::memory_order_relaxed) == m_sentSequence)
            open = false;
        if (station::steadyNow_ns() >= m_nextHealth_ns)
            publishHealth();
    }
}

/// Sends the newest command, if it was not sent yet.
bool StationLink::sendNewest() noexcept {
    station_output output{};
    if (!m_transport || !m_output.read(output))
        return false;
    send(output);
    return true;
}

/// Takes every frame that is there, at most kMostAtOnce; only the newest input is handed on, the others are
/// counted.
void StationLink::takeAll(std::int64_t deadline_ns) noexcept {
    const std::uint32_t before = m_last.packet;
    std::uint64_t taken = 0;
    station::FrameBytes bytes{};
    for (int frames = 0; frames < kMostAtOnce; ++frames) {
        const station::Received got = m_transport->receive(bytes, frames == 0 ? deadline_ns : 0);
        if (got == station::Received::nothing)
            break;
        if (got == station::Received::gone) {
            lose();
            return;
        }
        const std::uint64_t counted = m_counts.received;
        take(bytes, station::steadyNow_ns());
        taken += m_counts.received - counted;
    }
    m_counts.overtaken += taken > 1 ? taken - 1 : 0;
    if (m_last.packet != before)
        m_input.publish(m_last);
    if (std::exchange(m_stepDone, false)) { // after the input: who waited for the step finds it
        const std::lock_guard lock(m_steps);
        m_stepped.store(m_sentSequence, std::memory_order_release);
        m_stepChanged.notify_all();
    }
}

void StationLink::take(const station::FrameBytes& bytes, std::int64_t arrival_ns) noexcept {
    station_input input{};
    switch (station_decode_input(bytes.data(), &input)) {
    case STATION_OK:
        takeInput(input, arrival_ns);
        return;
    case STATION_BAD_CRC:
        ++m_counts.badCrc;
        return;
    case STATION_BAD_TYPE:
    case STATION_BAD_VALUE:
        break;
    }
    std::uint8_t page = 0, status = 0;
    if (station_decode_feature_head(bytes.data(), &page, &status) != STATION_OK)
        ++m_counts.badFrames;
    else
        m_stepDone = m_settings.identity.lockstep; // a stepped station ends each step with its counters
}

void StationLink::takeInput(const station_input& input, std::int64_t arrival_ns) noexcept {
    if (!m_fresh && !station_newer(input.sequence, m_last.input.sequence)) {
        ++m_counts.stale;
        // Nothing but old numbers, one after the other: it has started again on a line that did not notice.
        m_staleInRow =
            input.sequence == static_cast<std::uint16_t>(m_staleSequence + 1) ? m_staleInRow + 1 : 0;
        m_staleSequence = input.sequence;
        if (m_staleInRow < kStartedAgain)
            return;
        ++m_counts.interruptions;
        m_fresh = true;
    }
    m_staleInRow = 0;
    const std::uint32_t gap = m_fresh ? 0 : station_gap(input.sequence, m_last.input.sequence);
    // A new line may have a new clock: it goes on from where the old one was, by our own.
    const std::uint64_t passed_us =
        m_fresh ? static_cast<std::uint64_t>(std::max<std::int64_t>(arrival_ns - m_last.arrival_ns, 0)) /
                      static_cast<std::uint64_t>(kMicrosecond_ns)
                : input.time_us - m_last.input.time_us;
    if (!m_fresh && passed_us > 0x7FFFFFFFu) { // the number goes on, but the clock goes back
        ++m_counts.badFrames;
        return;
    }
    m_counts.lost += gap;
    ++m_counts.received;
    if (!m_fresh) {
        m_counts.letGo +=
            (input.status & STATION_STATUS_LET_GO) != 0 && (m_last.input.status & STATION_STATUS_LET_GO) == 0
                ? 1
                : 0;
        noteRoundTrip(input, arrival_ns);
    }
    if (input.state == STATION_FAULT && (m_fresh || m_last.input.state != STATION_FAULT)) {
        ++m_counts.faults;
        m_counts.lastFault = input.fault;
    }
    m_last.input = input;
    m_last.packet += 1 + gap;
    m_last.deviceTime_us += passed_us;
    m_last.arrival_ns = arrival_ns;
    m_last.gone = false;
    m_fresh = false;
}

void StationLink::noteRoundTrip(const station_input& input, std::int64_t arrival_ns) noexcept {
    if (input.applied_age_ms == 255 || input.applied_sequence == m_last.input.applied_sequence)
        return;
    std::int64_t& sent_ns = m_sentAt_ns[input.applied_sequence % m_sentAt_ns.size()];
    if (sent_ns == 0)
        return;
    const std::int64_t trip_ns = std::max<std::int64_t>(arrival_ns - sent_ns, 0);
    sent_ns = 0;
    ++m_roundTrips[std::min(static_cast<std::size_t>(trip_ns / kBin_ns), kBins - 1)];
    ++m_roundTripCount;
    m_counts.roundTripMost_us =
        std::max(m_counts.roundTripMost_us, static_cast<std::uint32_t>(trip_ns / kMicrosecond_ns));
}

void StationLink::send(const station_output& output) noexcept {
    station::FrameBytes frame{};
    if (station_encode_output(&output, frame.data()) != STATION_OK)
        return;
    m_sentSequence = output.sequence;
    m_sentAt_ns[output.sequence % m_sentAt_ns.size()] = station::steadyNow_ns();
    switch (m_transport->send(frame)) {
    case station::Sent::sent:
        ++m_counts.sent;
        break;
    case station::Sent::dropped:
        ++m_counts.notTaken;
        break;
    case station::Sent::gone:
        lose();
        break;
    }
}

void StationLink::lose() noexcept {
    m_brokenBefore += m_transport->malformed();
    m_transport->close();
    m_transport.reset();
    ++m_counts.interruptions;
    m_last.gone = true;
    m_input.publish(m_last);
    const std::lock_guard lock(m_steps);
    m_gone.store(true, std::memory_order_relaxed);
    m_stepChanged.notify_all();
}

/// True if the same station answers again.
bool StationLink::reconnect() {
    auto transport = connectStation(m_settings.address);
    if (!transport)
        return false;
    const auto identity = identifyStation(**transport, m_settings.where);
    if (!identity || !isSameStation(*identity, m_settings.identity))
        return false;
    m_transport = std::move(*transport);
    m_fresh = true;
    m_sentAt_ns = {};
    station_output missed{};
    (void)m_output.read(missed); // a command from before is no command now
    return true;
}

void StationLink::sayFarewell() noexcept {
    if (!m_transport)
        return;
    const std::int64_t end_ns = station::steadyNow_ns() + kFarewell_ns;
    station_output unsent{}; // what the tick put last goes first, if it was not sent: its number is older
    if (m_output.read(unsent))
        m_sentSequence = unsent.sequence;
    const auto first = static_cast<std::uint16_t>(m_sentSequence + 1);
    while (m_transport && station::steadyNow_ns() < end_ns) {
        m_sentSequence = static_cast<std::uint16_t>(m_sentSequence + 1);
        if (m_transport->send(idleOutput(m_sentSequence, m_last.input.sequence)) == station::Sent::gone)
            break;
        ++m_counts.sent;
        takeAll(station::steadyNow_ns() + kMillisecond_ns);
        const station_input& input = m_last.input;
        if (input.applied_age_ms < 255 && !station_newer(first, input.applied_sequence) &&
            input.state != STATION_ARMED)
            break;
    }
    if (m_transport) {
        m_brokenBefore += m_transport->malformed();
        m_transport->close();
        m_transport.reset();
    }
}

void StationLink::publishHealth() noexcept {
    StationHealth health = m_counts;
    health.connected = m_transport != nullptr;
    health.badCrc += m_brokenBefore + (m_transport ? m_transport->malformed() : 0);
    health.roundTrip50_us = percentile_us(m_roundTrips, m_roundTripCount, 0.50, kBin_ns);
    health.roundTrip99_us = percentile_us(m_roundTrips, m_roundTripCount, 0.99, kBin_ns);
    m_health.publish(health);
    m_nextHealth_ns = station::steadyNow_ns() + kHealth_ns;
}

} // namespace chiron::devices
