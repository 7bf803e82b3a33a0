// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/json_file.h"
#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <QByteArray>
#include <cstdint>
#include <string>

namespace chiron::catalogue {

/// Reads a study from its JSON; content/schema/study.json documents every key. Unknown keys are refused, and
/// all faults are reported together.
/// Errors: badInput, one line `file:line:column: $.path: found: expected ...` for each fault.
core::Result<psychophysics::StudyDesign> readStudy(const QByteArray& json, const std::string& file);
/// Reads a study from `document`, which is the content of `file` with translations laid over it. Faults are
/// reported with their places in the file.
core::Result<psychophysics::StudyDesign> readStudy(const QJsonObject& document, const JsonFile& file);

/// The largest seed, 2^53 - 1: a JSON number holds every integer up to here exactly.
inline constexpr std::uint64_t kLargestSeed = 9007199254740991;

/// Writes the canonical JSON of a study: keys sorted, no spaces, every key that applies written out. Reading
/// and writing it again gives the same bytes.
QByteArray studyJson(const psychophysics::StudyDesign& design);

/// The range allowed for the reference and for every presented value of an attribute, in SI units.
struct ValueRange {
    double lowest = 0.0;
    double highest = 0.0;
};
ValueRange valueRange(psychophysics::Attribute attribute);

/// Returns whether a task also takes objects with less of the attribute than the reference. This is so where
/// the person says, sets or judges whether an object has more than the reference.
bool takesBothSides(psychophysics::Task task) noexcept;

/// Returns a reference that keeps every object of the condition's table in range and lies in the (geometric)
/// middle of the attribute's range. It does not depend on the condition's own reference.
double middleReference(const psychophysics::Condition& condition);

/// Returns the SHA-256 of the bytes as 64 hex digits. A study is frozen under the digest of its studyJson.
std::string studySha256(const QByteArray& json);

} // namespace chiron::catalogue
