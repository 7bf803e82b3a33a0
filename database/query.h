// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/value.h"

#include <QSqlQuery>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace chiron::database {

/// One prepared statement with its values bound, forward only. Every value is bound; none is ever pasted into
/// SQL.
class Query {
public:
    /// Prepares, binds and runs.
    /// Errors: storage with SQLite's message; badInput for text that is not UTF-8 and for NaN or infinity.
    static core::Result<Query> run(Connection& connection, const std::string& sql,
                                   const std::vector<Value>& values = {});

    /// Steps to the next row; false after the last one.
    /// Errors: storage.
    core::Result<bool> next();

    bool isNull(int column) const;
    std::int64_t integer(int column) const;
    double real(int column) const;
    std::string text(int column) const;
    Blob blob(int column) const;
    Value value(int column) const;

    /// Returns the number of rows that the statement changed.
    int rowsChanged() const { return m_query.numRowsAffected(); }

private:
    explicit Query(QSqlQuery query, std::string file) : m_query(std::move(query)), m_file(std::move(file)) {}
    QSqlQuery m_query;
    std::string m_file;
};

/// Returns the first column of the first row as an integer; none if there is no row or it is NULL.
core::Result<std::optional<std::int64_t>> selectInteger(Connection& connection, const std::string& sql,
                                                        const std::vector<Value>& values = {});
/// Returns the first column of the first row as text; none if there is no row or it is NULL.
core::Result<std::optional<std::string>> selectText(Connection& connection, const std::string& sql,
                                                    const std::vector<Value>& values = {});

/// Returns Error{storage} with the file, what was done, and SQLite's message; a full disk is reported as
/// such.
core::Error storageError(const std::string& file, const std::string& what, int extendedCode,
                         const std::string& words);

} // namespace chiron::database
