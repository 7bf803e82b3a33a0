// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace chiron::simulation {

/// Weights of the last three answers of a slow model at one tick; they sum to 1.
struct BlendWeights {
    double newest = 1.0;   ///< of A(k)
    double previous = 0.0; ///< of A(k-1)
    double before = 0.0;   ///< of A(k-2)
};

/// Computes the value that the fast loop shows between two answers of a slow model. It predicts from the last
/// answers and blends the old and the new prediction after each update (P2, "Haptic-Visual Graphic
/// Integration"; models.md §2.2, two rates). Answer A(k) belongs to the request of tick n(k) and is applied
/// at tick t(k) ≥ n(k) + L.
///
///   prediction   P_k(t) = A(k) + γ e_k(t) (A(k) − A(k−1)),  e_k = min(1, (t − n(k)) / (n(k) − n(k−1)))
///   shown        x(t) = (1 − s(w)) P_{k−1}(t) + s(w) P_k(t),  w = min(1, (t − t(k)) / B),  s(w) = 3w² − 2w³
///
/// The prediction extends over at most one interval between answers, and only by the share γ of it. Because B
/// ≤ L and the next answer comes at t(k) + L at the earliest, w has reached 1 by then and x is continuous
/// whenever an answer is applied. From one tick to the next, x moves by at most 1.5/B ‖P_k − P_{k−1}‖ + γ
/// ‖A(k) − A(k−1)‖ / (n(k) − n(k−1)) (plus the same term of k−1 while it fades). Everything is a linear
/// combination of three answers, so a tick computes only three weights, however large an answer is.
///
/// Thread: haptic.
class AnswerBlend {
public:
    /// `blend_ticks` = B, 1..L; `prediction` = γ, 0..1.
    AnswerBlend(std::uint64_t blend_ticks, double prediction) noexcept
        : m_blend_ticks(std::max<std::uint64_t>(1, blend_ticks)), m_prediction(prediction) {}

    /// Clears the history: from here on all three answers have number 0, the model at rest.
    void reset(std::uint64_t tick) noexcept {
        m_numbers = {};
        m_asked = {tick, tick, tick};
        m_appliedAt = tick;
        m_settled = true;
    }

    /// Lets answer `number` (SlowLink::number()), which belongs to the request of tick `asked`, take effect.
    void apply(std::uint64_t tick, std::uint64_t asked, std::uint64_t number) noexcept {
        m_numbers = {number, m_numbers[0], m_numbers[1]};
        m_asked = {asked, m_asked[0], m_asked[1]};
        m_appliedAt = tick;
        m_settled = false;
    }

    /// Numbers of A(k), A(k-1), A(k-2); 0 is the model at rest.
    const std::array<std::uint64_t, 3>& numbers() const noexcept { return m_numbers; }

    BlendWeights weights(std::uint64_t tick) const noexcept {
        if (m_settled)
            return {};
        const double s = blended(tick);
        const double newer = reach(tick, m_asked[0], m_asked[1]);
        const double older = reach(tick, m_asked[1], m_asked[2]);
        return {s * (1.0 + newer), (1.0 - s) * (1.0 + older) - s * newer, -(1.0 - s) * older};
    }

    /// Weights without prediction (γ = 0): the last answers are held and blended in the same way.
    BlendWeights heldWeights(std::uint64_t tick) const noexcept {
        if (m_settled)
            return {};
        const double s = blended(tick);
        return {s, 1.0 - s, 0.0};
    }

private:
    /// s(w)
    double blended(std::uint64_t tick) const noexcept {
        const double w =
            std::min(1.0, static_cast<double>(tick - m_appliedAt) / static_cast<double>(m_blend_ticks));
        return w * w * (3.0 - 2.0 * w);
    }

    /// γ e(t); 0 where two answers belong to the same tick (after reset()).
    double reach(std::uint64_t tick, std::uint64_t asked, std::uint64_t askedBefore) const noexcept {
        if (asked <= askedBefore || tick <= asked)
            return 0.0;
        return m_prediction *
               std::min(1.0, static_cast<double>(tick - asked) / static_cast<double>(asked - askedBefore));
    }

    std::uint64_t m_blend_ticks;
    double m_prediction;
    std::array<std::uint64_t, 3> m_numbers{};
    std::array<std::uint64_t, 3> m_asked{}; ///< n(k), n(k-1), n(k-2)
    std::uint64_t m_appliedAt = 0;          ///< t(k)
    bool m_settled = true;
};

} // namespace chiron::simulation
