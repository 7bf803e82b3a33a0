// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/study_reader.h"

#include <filesystem>

namespace chiron::session {

// A study's data for others, pseudonymised: participants go by their codes, with no name, identity, account or clock time; times count
// from the start of a run. While a study with a blind experimenter is not unblinded, conditions go by their sealed codes and what would
// give them away (reference, unit, values) is left out. Text is UTF-8 and locale-free, numbers the shortest decimal that reads back as
// the same double, "n/a" where there is none. The SHA-256 of the frozen design is in every file that can hold it. Any thread that the
// reader's connection belongs to.

/// Writes `folder`: trials, runs, participants (with what was written down at the enrolment), questionnaires, scores and estimates as CSV, data_dictionary.csv and .json (every column with
/// unit, levels and description), design.json (the frozen design, byte for byte what the SHA-256 is of), dataset_description.json (Psych-DS). The
/// folder appears whole or not at all. Failure: badInput where `folder` exists already, wrongUse for a draft, notFound, notAllowed, storage.
core::Result<void> exportStudyCsv(database::StudyReader& reader, database::StudyNumber study, const std::filesystem::path& folder);

/// Writes `folder` as a BIDS dataset: sub-CODE/beh with a `_beh.tsv` a run and, where recordings are there and `actor` may read them,
/// sub-CODE/motion with the tool's motion, forces as MISC channels, and events. Failure: as above.
core::Result<void> exportStudyBids(database::StudyReader& reader, database::Connection& connection, const database::Actor& actor,
                                   database::StudyNumber study, const std::filesystem::path& folder);

} // namespace chiron::session
