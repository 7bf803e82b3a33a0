// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/trace.h"

#include <optional>

namespace chiron::scoring {

/// What tissue answered beside what was commanded to the device, over the running samples of every tool and trial. N, s.
struct ForceFacts {
    double tissue_N = 0.0;
    double commanded_N = 0.0; ///< 0 on a device that renders no force
    double limited_s = 0.0;   ///< how long any tool was commanded less than the tissue answered, by more than kLimited_N
    std::optional<double> firstLimited_s; ///< time of the first such sample
    std::size_t samples = 0;
    std::size_t beyondChecked = 0; ///< of these, outside the poses and depths for which the law was checked (core::contact_bits)

    double beyondCheckedShare() const noexcept {
        return samples == 0 ? 0.0 : static_cast<double>(beyondChecked) / static_cast<double>(samples);
    }
};

/// Less than this is no limit that a hand could notice: a tenth of the weakest force that is taught.
inline constexpr double kLimited_N = 0.05;

/// Pauses are left out. A trace without commanded forces limits nothing. Source: data.md, Three wrenches and Range of a law. Pure.
ForceFacts forceFactsOf(const SessionTrace& trace);

} // namespace chiron::scoring
