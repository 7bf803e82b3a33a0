// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/integrity/row_digest.h"
#include "database/query.h"
#include "database/value.h"

#include <string_view>
#include <vector>

namespace chiron::database {

/// Inserts a row with its digest; columns that the digest covers and that are not given are NULL. -0.0
/// becomes 0.0. Returns the digest. Failure: badInput (not finite, not UTF-8), storage. Writer's connection
/// only.
core::Result<RowDigest> insertRow(Connection& connection, std::string_view table,
                                  std::vector<Column> columns);

/// Changes columns of one row and renews its digest; first checks that the row still fits its old one, so
/// that damage is never signed over. Failure: notFound, storage (damaged row), as insertRow.
core::Result<RowDigest> updateRow(Connection& connection, std::string_view table,
                                  const std::vector<Column>& key, std::vector<Column> changes);

/// The covered values of the query's present row, whose select list begins with rawSelectList at this column.
std::vector<Value> rawValues(const Query& query, const DigestedTable& table, int firstColumn);

} // namespace chiron::database
