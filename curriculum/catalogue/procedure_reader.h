// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"
#include "catalogue/schema.h"
#include "core/result.h"
#include "psychophysics/procedures/procedure_spec.h"

#include <QByteArray>
#include <QJsonObject>
#include <string>

namespace chiron::catalogue {

/// A procedure from its JSON object; content/schema/procedure.json says what each key means. Keys left out keep the defaults of
/// procedure_spec.h. A missing or wrong value, a key that its kind does not know, and what the procedure itself refuses are added to
/// the problems.
psychophysics::ProcedureSpec readProcedure(const ObjectReader& json);

/// The same from a file of its own, which must also keep the limits of the schema (procedure.json; a frozen study is read without any).
/// Failure: badInput, every fault as `file:line:column: $.path: found: expected ...`.
core::Result<psychophysics::ProcedureSpec> readProcedure(const QByteArray& json, const std::string& file, const Schema& schema);

/// What readProcedure reads back to the same procedure: every key of its kind.
QJsonObject writeProcedure(const psychophysics::ProcedureSpec& spec);

} // namespace chiron::catalogue
