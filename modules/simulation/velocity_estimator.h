// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"

#include <array>
#include <cstdint>

namespace chiron::simulation {

/// The program's only velocity estimator (models.md §0). It uses first-order adaptive windowing, FOAW
/// (Janabi-Sharifi, Hayward & Chen 2000, "Discrete-time adaptive windowing for velocity estimation", IEEE
/// Trans. Control Syst. Technol. 8(6)), on the integer counts of one tool, separately for each axis, against
/// device time.
///
/// The window grows backwards from the newest sample, up to 15 ms of device time, as long as every sample in
/// it lies within one count of the straight line through its two ends (the paper's end-fit test; for a steady
/// motion rounded to whole counts it holds whatever the window, so slow motion always gets all 15 ms). Over
/// that window the velocity is the least-squares slope (the paper's best fit), so a single count passing
/// through the window raises and lowers the estimate smoothly where the end-fit slope would jump by one count
/// per 15 ms.
///
/// The delay is half the window, at most 7.5 ms for steady acceleration; the estimate follows a step of
/// velocity completely within 15 ms. A still tool gives exactly 0. The end-fit test and the sums use
/// integers, and one division per coordinate yields the double, so that every machine computes the same
/// value. Copyable (fixed storage); each tool has one instance.
///
/// Unit: counts/s of the device's grid.
/// Thread: haptic; allocates nothing.
class VelocityEstimator {
public:
    using Rates = std::array<double, core::kMaxCoordinates>; ///< counts/s

    static constexpr std::int64_t kWindow_us = 15000; ///< models.md §0
    static constexpr std::int64_t kNoiseBound_counts = 1;
    static constexpr int kCapacity = 64; ///< 15 ms at 4 kHz; a faster device gets a shorter window

    /// `coordinates`: how many axes the device has (clamped to 1..kMaxCoordinates); the others read 0.
    explicit VelocityEstimator(int coordinates = core::kMaxCoordinates) noexcept;

    /// Takes in a new packet. A packet that was already seen, an older one, or one marked kInvalid leaves the
    /// estimate as it is (a packet that is read again has aged; it does not say that the tool rests, and the
    /// supervisor's watchdog deals with it). A gap of more than 15 ms of device time between packets, or
    /// device time that does not advance, clears the history; the estimate is then 0 until the next packet.
    const Rates& update(const core::DeviceSample& sample) noexcept;

    const Rates& rates() const noexcept { return m_rates; }
    void reset() noexcept; ///< clears the history

private:
    void push(const core::DeviceSample& sample) noexcept;
    double slope(int axis) const noexcept;

    struct Entry {
        std::uint64_t time_us = 0;
        std::array<std::int32_t, core::kMaxCoordinates> counts{};
    };
    const Entry& entry(int age) const noexcept; ///< 0 = newest

    std::array<Entry, kCapacity> m_history{}; ///< ring; m_newest is the last written
    Rates m_rates{};
    int m_coordinates;
    int m_newest = 0;
    int m_size = 0; ///< samples inside the window
    std::uint32_t m_packet = 0;
};

} // namespace chiron::simulation
