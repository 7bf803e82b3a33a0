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

/// Reads a procedure from its JSON object; content/schema/procedure.json says what each key means. Keys that
/// are left out keep the defaults of procedure_spec.h. A missing or wrong value, a key that its kind does not
/// know, and anything that the procedure itself refuses are added to the problems.
psychophysics::ProcedureSpec readProcedure(const ObjectReader& json);

/// Reads a procedure from a file of its own, which must also keep the limits of the schema (procedure.json).
/// A frozen study is read without those limits.
/// Errors: badInput, naming every fault as `file:line:column: $.path: found: expected ...`.
core::Result<psychophysics::ProcedureSpec> readProcedure(const QByteArray& json, const std::string& file,
                                                         const Schema& schema);

/// Writes every key of the procedure's kind, so that readProcedure reads the same procedure back.
QJsonObject writeProcedure(const psychophysics::ProcedureSpec& spec);

} // namespace chiron::catalogue
