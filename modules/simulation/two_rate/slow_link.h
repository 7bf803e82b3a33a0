// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "realtime/latest_value.h"
#include "simulation/slow_model.h"

#include <cstdint>

namespace chiron::simulation {

/// How often a slow model is asked, and how long after its question an answer takes effect; in executed ticks of 1 ms.
struct TwoRateTiming {
    std::uint64_t period_ticks = 33;  ///< at least so long from one request to the next: 30 Hz (P2); 10..34 (30-100 Hz)
    std::uint64_t latency_ticks = 33; ///< L: the answer of tick n is due at n + L (architecture.md, Determinism)
};

/// The way from a scene's tick to its slow model and back (architecture.md, "Two rates").
///
/// A request goes out only when the last answer has been applied and a period has passed, so that at most one is on its way:
/// nothing can overtake, get lost or be answered twice, and everything that a slow model ever does follows from the ticks at
/// which answers were applied. Those are recorded (event_bits::kSlowApplied); a late or held-up model changes them and
/// nothing else. Request and answer travel through triple buffers: neither side waits, allocates or sees half a value.
///
/// What is too large to be copied in a tick (a shape) stays where the model wrote it: the buffers carry numbers that count
/// requests, and a model with one slot more than the reader uses writes where nobody reads (kSlots).
///
/// `Request` and `Answer` are trivially copyable. Thread: the functions of the tick haptic; serve() the slow model's.
template <class Request, class Answer>
class SlowLink {
public:
    /// Slots for shapes: the reader uses the last three answers (AnswerBlend), the model writes the fourth.
    static constexpr std::size_t kSlots = 4;
    static constexpr std::size_t slotOf(std::uint64_t number) noexcept { return static_cast<std::size_t>(number % kSlots); }

    explicit SlowLink(const TwoRateTiming& timing = {}) noexcept : m_timing(timing) {}
    SlowLink(const SlowLink&) = delete;
    SlowLink& operator=(const SlowLink&) = delete;

    /// Whether a request may go out at this tick. Tick.
    bool mayPost(std::uint64_t tick) const noexcept {
        return !m_waiting && (m_posted == 0 || tick >= m_postedAt + m_timing.period_ticks);
    }

    /// Sends a request; only where mayPost(). Tick.
    void post(std::uint64_t tick, const Request& request) noexcept {
        m_waiting = true;
        m_postedAt = tick;
        m_requests.publish({++m_posted, request});
    }

    /// Applies the answer that is on its way, if it takes effect at this tick: true, and answer() is the new one. `when` comes
    /// with the tick's inputs; in lock-step (as-fast, replay) `model` is stepped here and now. Tick.
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

    const Answer& answer() const noexcept { return m_answer; }           ///< the last one applied. Tick.
    std::uint64_t number() const noexcept { return m_posted; }           ///< of the last request, 1, 2, ... Tick.
    std::uint64_t postedAt_ticks() const noexcept { return m_postedAt; } ///< of the last request. Tick.
    bool waiting() const noexcept { return m_waiting; }                  ///< an answer is on its way. Tick.

    /// Answers the newest request if it has not been answered: `solve(number, request)` gives the answer. Slow model.
    template <class Solve>
    bool serve(Solve&& solve) noexcept {
        Numbered<Request> newest;
        m_requests.read(newest);
        if (newest.number == m_served)
            return false;
        m_served = newest.number;
        m_answers.publish({newest.number, solve(newest.number, newest.value)});
        return true;
    }

private:
    template <class T>
    struct Numbered {
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
    alignas(64) std::uint64_t m_served = 0; ///< slow model's
};

} // namespace chiron::simulation
