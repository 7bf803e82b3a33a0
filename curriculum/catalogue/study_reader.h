// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/json_file.h"
#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <QByteArray>
#include <string>

namespace chiron::catalogue {

/// A study from its JSON (content/schema/study.json documents every key). Strict: unknown keys are refused, everything wrong is told
/// together. Failure (badInput): `file:line:column: $.path: found: expected ...`, a line each.
core::Result<psychophysics::StudyDesign> readStudy(const QByteArray& json, const std::string& file);
/// The same of `document`, which is what `file` holds with translations laid over it. Faults are told with their places in the file.
core::Result<psychophysics::StudyDesign> readStudy(const QJsonObject& document, const JsonFile& file);

/// The canonical JSON of a study: keys sorted, no spaces, every key that applies written out. Reading and writing it again gives the
/// same bytes.
QByteArray studyJson(const psychophysics::StudyDesign& design);

/// What a reference and every presented value of an attribute may be, SI.
struct ValueRange {
    double lowest = 0.0;
    double highest = 0.0;
};
ValueRange valueRange(psychophysics::Attribute attribute);

/// Whether a task takes objects with less of the attribute than the reference, too: where "more than the reference" is asked, set or said.
bool takesBothSides(psychophysics::Task task) noexcept;

/// A reference that is in range with every object of the condition's table, and in the middle of what its attribute can be: says nothing of
/// what the condition's own is.
double middleReference(const psychophysics::Condition& condition);

/// SHA-256 of the bytes, 64 hex digits; of studyJson: what a study is frozen under.
std::string studySha256(const QByteArray& json);

} // namespace chiron::catalogue
