// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/digested_row.h"

#include <algorithm>

namespace chiron::database {
namespace {

void normalise(std::vector<Column>& columns) {
    for (Column& column : columns) {
        if (column.value.type() == Value::Type::real) {
            column.value = Value(column.value.real() + 0.0); // SQLite stores -0.0 as 0.0
        }
    }
}

const Value* find(const std::vector<Column>& columns, std::string_view name) {
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
    return found == columns.end() ? nullptr : &found->value;
}

std::string whereOf(const std::vector<Column>& key) {
    std::string text;
    for (const Column& column : key) {
        text += (text.empty() ? " WHERE " : " AND ") + std::string(column.name) + " = ?";
    }
    return text;
}

std::vector<Value> valuesOf(const std::vector<Column>& columns) {
    std::vector<Value> values;
    for (const Column& column : columns) {
        values.push_back(column.value);
    }
    return values;
}

core::Result<std::vector<Value>> presentValues(Connection& connection, const DigestedTable& spec,
                                               const std::vector<Column>& key) {
    auto query =
        Query::run(connection,
                   "SELECT " + rawSelectList(spec) + ", digest FROM " + std::string(spec.name) + whereOf(key),
                   valuesOf(key));
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    if (!*row) {
        return core::fail(core::ErrorCode::notFound, "there is no such row in " + std::string(spec.name));
    }
    auto values = rawValues(*query, spec, 0);
    if (query->blob(static_cast<int>(2 * spec.columns.size())) != toBlob(rowDigest(spec.name, values))) {
        return core::fail(core::ErrorCode::storage, connection.file() + ": a row of " +
                                                        std::string(spec.name) +
                                                        " is damaged (its digest does not fit); run verify");
    }
    return values;
}

} // namespace

core::Result<RowDigest> insertRow(Connection& connection, std::string_view table,
                                  std::vector<Column> columns) {
    normalise(columns);
    const DigestedTable& spec = digestedTable(table);
    std::vector<Value> covered;
    for (const std::string_view name : spec.columns) {
        const Value* value = find(columns, name);
        covered.push_back(value != nullptr ? *value : Value{});
    }
    const RowDigest digest = rowDigest(table, covered);
    columns.push_back({"digest", toBlob(digest)});
    std::string names;
    std::string marks;
    for (const Column& column : columns) {
        names += (names.empty() ? "" : ", ") + std::string(column.name);
        marks += marks.empty() ? "?" : ", ?";
    }
    auto done = Query::run(connection,
                           "INSERT INTO " + std::string(table) + " (" + names + ") VALUES (" + marks + ")",
                           valuesOf(columns));
    CHIRON_TRY(done);
    return digest;
}

core::Result<RowDigest> updateRow(Connection& connection, std::string_view table,
                                  const std::vector<Column>& key, std::vector<Column> changes) {
    normalise(changes);
    const DigestedTable& spec = digestedTable(table);
    auto values = presentValues(connection, spec, key);
    CHIRON_TRY(values);
    for (std::size_t i = 0; i < spec.columns.size(); ++i) {
        if (const Value* changed = find(changes, spec.columns[i])) {
            (*values)[i] = *changed;
        }
    }
    const RowDigest digest = rowDigest(table, *values);
    changes.push_back({"digest", toBlob(digest)});
    std::string sets;
    for (const Column& column : changes) {
        sets += (sets.empty() ? "" : ", ") + std::string(column.name) + " = ?";
    }
    std::vector<Value> bound = valuesOf(changes);
    for (const Column& column : key) {
        bound.push_back(column.value);
    }
    auto done = Query::run(connection, "UPDATE " + std::string(table) + " SET " + sets + whereOf(key), bound);
    CHIRON_TRY(done);
    return digest;
}

std::vector<Value> rawValues(const Query& query, const DigestedTable& table, int firstColumn) {
    std::vector<Value> values;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const int column = firstColumn + static_cast<int>(2 * i);
        const std::string type = query.text(column);
        if (type == "text") {
            const Blob bytes = query.blob(column + 1);
            values.emplace_back(std::string(bytes.begin(), bytes.end()));
        } else if (type == "blob") {
            values.emplace_back(query.blob(column + 1));
        } else {
            values.push_back(query.value(column + 1));
        }
    }
    return values;
}

} // namespace chiron::database
