// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "realtime/latest_value.h"
#include "simulation/slow_model.h"

#include <cstdint>

namespace chiron::simulation {

/// How often a slow model is asked, and how long after a request its answer takes effect.
/// Unit: executed ticks of 1 ms.
struct TwoRateTiming {
    std::uint64_t period_ticks = 33; ///< least time between two requests: 30 Hz (P2); 10..34 (30-100 Hz)
    /// L: the answer to the request of tick n is due at n + L (architecture.md, Determinism).
    std::uint64_t latency_ticks = 33;
};

/// Carries requests from a scene's tick to its slow model and answers back (architecture.md, "Two rates").
///
/// A request goes out only when the last answer has been applied and a period has passed, so at most one
/// request is in flight. No request can therefore overtake another, get lost or be answered twice, and the
/// slow model's behaviour follows entirely from the ticks at which answers were applied. The recording stores
/// these ticks (event_bits::kSlowApplied); a late or stalled model changes them and nothing else. Requests
/// and answers travel through triple buffers: neither side waits, allocates or sees half a value.
///
/// A value that is too large to copy in a tick (a shape) stays where the model wrote it. The buffers carry
/// numbers that count requests, and the model has one slot more than the reader uses, so it writes where
/// nobody reads (kSlots).
///
/// `Request` and `Answer` are trivially copyable.
/// Thread: slow model for serve(), haptic for all other functions.
template <class Request, class Answer> class SlowLink {
public:
    /// Slots for shapes: the reader uses the last three answers (AnswerBlend) while the model writes the
    /// fourth.
    static constexpr std::size_t kSlots = 4;
    static constexpr std::size_t slotOf(std::uint64_t number) noexcept {
        return static_cast<std::size_t>(number % kSlots);
    }

    explicit SlowLink(const TwoRateTiming& timing = {}) noexcept : m_timing(timing) {}
    SlowLink(const SlowLink&) = delete;
    SlowLink& operator=(const SlowLink&) = delete;

    /// Says whether a request may go out at this tick.
    /// Thread: haptic.
    bool mayPost(std::uint64_t tick) const noexcept {
        return !m_waiting && (m_posted == 0 || tick >= m_postedAt + m_timing.period_ticks);
    }

    /// Sends a request. Precondition: mayPost().
    /// Thread: haptic.
    void post(std::uint64_t tick, const Request& request) noexcept {
        m_waiting = true;
        m_postedAt = tick;
        m_requests.publish({++m_posted, request});
    }

    /// Applies the pending answer if it takes effect at this tick; then returns true, and answer() is the new
    /// one. `when` comes with the tick's inputs. In lock-step (faster than real time, replay) this call steps
    /// `model`.
    /// Thread: haptic.
    bool take(std::uint64_t tick, SlowUpdate when, ISlowModel& model) noexcept {
        if (!m_waiting || when == SlowUpdate::notNow)
            return false;
        if (when != SlowUpdate::now && tick < m_postedAt + m_timing.latency_ticks)
            return false;
        if (when != SlowUpdate::whenReady)
            model.step();
        Numbered<Answer> newest;
        if (!m_answers.read(newest) || newest.number != m_posted)
            return false;
        m_answer = newest.value;
        m_waiting = false;
        return true;
    }

    /// The last answer that was applied.
    /// Thread: haptic.
    const Answer& answer() const noexcept { return m_answer; }
    /// Number of the last request: 1, 2, ...
    /// Thread: haptic.
    std::uint64_t number() const noexcept { return m_posted; }
    /// Tick of the last request.
    /// Thread: haptic.
    std::uint64_t postedAt_ticks() const noexcept { return m_postedAt; }
    /// The answer to the last request has not been applied yet.
    /// Thread: haptic.
    bool waiting() const noexcept { return m_waiting; }

    /// Answers the newest request if it has not been answered; `solve(number, request)` computes the answer.
    /// Returns false if there was nothing to answer.
    /// Thread: the slow model's.
    template <class Solve> bool serve(Solve&& solve) noexcept {
        Numbered<Request> newest;
        m_requests.read(newest);
        if (newest.number == m_served)
            return false;
        m_served = newest.number;
        m_answers.publish({newest.number, solve(newest.number, newest.value)});
        return true;
    }

private:
    template <class T> struct Numbered {
        std::uint64_t number = 0;
        T value{};
    };

    TwoRateTiming m_timing;
    bool m_waiting = false;
    std::uint64_t m_posted = 0;
    std::uint64_t m_postedAt = 0;
    Answer m_answer{};
    realtime::LatestValue<Numbered<Request>> m_requests;
    realtime::LatestValue<Numbered<Answer>> m_answers;
    alignas(64) std::uint64_t m_served = 0; ///< used by the slow model's thread only
};

} // namespace chiron::simulation
