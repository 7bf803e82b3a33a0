// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/study_reader.h"

#include <filesystem>

namespace chiron::session {

// The pseudonymised export of a study's data. Participants are identified by their codes, without name,
// identity, account or clock time; times count from the start of a run. While a study with a blind
// experimenter is blinded, conditions are identified by their sealed codes, and everything that would reveal
// them (reference, unit, values) is omitted. Text is UTF-8 and independent of the locale, numbers are the
// shortest decimal that reads back as the same double, and "n/a" stands for a missing value. Every file that
// can hold the SHA-256 of the frozen design contains it. Call these functions on the thread to which the
// reader's connection belongs.

/// Writes `folder`: trials, runs, participants (with the facts recorded at enrolment), questionnaires, scores
/// and estimates as CSV, data_dictionary.csv and .json (every column with unit, levels and description),
/// design.json (the frozen design, byte for byte the text of the SHA-256), dataset_description.json
/// (Psych-DS). The folder appears either complete or not at all.
/// Errors: badInput if `folder` exists already; wrongUse for a draft; notFound; notAllowed; storage.
core::Result<void> exportStudyCsv(database::StudyReader& reader, database::StudyNumber study,
                                  const std::filesystem::path& folder);

/// Writes `folder` as a BIDS dataset: sub-CODE/beh with one `_beh.tsv` per run and, if there are recordings
/// that `actor` may read, sub-CODE/motion with the tool's motion, forces as MISC channels, and events.
/// Errors: those of exportStudyCsv().
core::Result<void> exportStudyBids(database::StudyReader& reader, database::Connection& connection,
                                   const database::Actor& actor, database::StudyNumber study,
                                   const std::filesystem::path& folder);

} // namespace chiron::session
