// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/connection.h"

namespace chiron::database {

/// Gives a job on the writer thread the only read-write connection, inside the job's transaction. Valid only
/// during the job.
class WriteContext {
public:
    explicit WriteContext(Connection& connection) : m_connection(connection) {}
    WriteContext(const WriteContext&) = delete;
    WriteContext& operator=(const WriteContext&) = delete;
    Connection& connection() noexcept { return m_connection; }

private:
    Connection& m_connection;
};

} // namespace chiron::database
