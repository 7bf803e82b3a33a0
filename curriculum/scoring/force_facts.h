// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/trace.h"

#include <optional>

namespace chiron::scoring {

/// Compares the force with which the tissue answered with the force commanded to the device, over the running
/// samples of every tool and trial. N, s.
struct ForceFacts {
    double tissue_N = 0.0;
    double commanded_N = 0.0; ///< 0 on a device that renders no force
    /// Time during which any tool was commanded less force than the tissue answered, by more than kLimited_N.
    double limited_s = 0.0;
    std::optional<double> firstLimited_s; ///< time of the first such sample
    std::size_t samples = 0;
    /// Samples outside the poses and depths for which the law was checked (core::contact_bits).
    std::size_t beyondChecked = 0;

    double beyondCheckedShare() const noexcept {
        return samples == 0 ? 0.0 : static_cast<double>(beyondChecked) / static_cast<double>(samples);
    }
};

/// A smaller difference is not a limitation that a hand could notice. It is a tenth of the weakest force that
/// is taught.
inline constexpr double kLimited_N = 0.05;

/// Computes the facts without pauses. A trace without commanded forces has no limited time. Source: data.md,
/// Three wrenches and Range of a law. The function is pure.
ForceFacts forceFactsOf(const SessionTrace& trace);

} // namespace chiron::scoring
