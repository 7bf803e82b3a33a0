// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/urethra_insertion/scoring/canal_series.h"

#include <memory>

namespace chiron::scoring {

/// The insertion series of a trial, to be changed. A series that another trial shares is copied first.
inline InsertionSeries& insertionIn(TrialTrace& trial) {
    if (trial.own.use_count() > 1)
        trial.own = std::make_shared<InsertionSeries>(*insertionOf(trial));
    return const_cast<InsertionSeries&>(*insertionOf(trial));
}

inline const InsertionSeries& insertionIn(const TrialTrace& trial) {
    return *insertionOf(trial);
}

} // namespace chiron::scoring
