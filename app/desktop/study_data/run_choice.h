// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

class QComboBox;

namespace chiron::desktop {

/// The run with this number, else the first one; null if there are no runs.
const RunFacts* runOf(const StudyFacts& facts, database::StudyRunNumber run);
/// A selection list of all runs, by participant's code and condition; the item data are the runs' numbers.
QComboBox* runChoice(AppContext& app, const StudyFacts& facts, const RunFacts* chosen);

} // namespace chiron::desktop
