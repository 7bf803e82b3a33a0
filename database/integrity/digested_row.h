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

/// Inserts a row with its digest and returns the digest. Columns that the digest covers and that are not
/// given are NULL. -0.0 becomes 0.0. Only for the writer's connection.
/// Errors: badInput (not finite, not UTF-8); storage.
core::Result<RowDigest> insertRow(Connection& connection, std::string_view table,
                                  std::vector<Column> columns);

/// Changes columns of one row and renews its digest. It first checks that the row still matches its old
/// digest, so that damage never receives a valid digest.
/// Errors: notFound; storage (damaged row); as insertRow.
core::Result<RowDigest> updateRow(Connection& connection, std::string_view table,
                                  const std::vector<Column>& key, std::vector<Column> changes);

/// Returns the covered values of the query's current row. The select list must begin with rawSelectList at
/// this column.
std::vector<Value> rawValues(const Query& query, const DigestedTable& table, int firstColumn);

} // namespace chiron::database
