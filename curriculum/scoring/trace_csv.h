// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/trace_rows.h"

#include <string>
#include <string_view>

namespace chiron::scoring {

/// Reads a trace file's text (cli.md, Trace files):
/// `t_s,x_mm,y_mm,z_mm[,qw,qx,qy,qz][,jaw_deg][,buttons][,tool]
/// [,fx_N,fy_N,fz_N]` and the columns of our own export (trace_columns.cpp, README), in any order. UTF-8, comma, decimal point whatever
/// the locale; LF or CRLF; a byte order mark and empty lines at the end are accepted. Times are rounded to
/// whole µs, positions to nm, forces to mN, torques to 0.01 mN·m (trace_grid.h). Failure (badInput): `name:line:column: "value":
/// expected ...`; nothing is repaired.
core::Result<TraceRows> readTraceCsv(std::string_view text, const std::string& name);

/// readTraceCsv of a file; refuses files over 2 GiB. Failure: notFound or badInput.
core::Result<TraceRows> readTraceCsvFile(const std::string& path);

/// The same format as exact decimals (whole µs, nm, mN, 0.01 mN·m), so that reading gives the same doubles bit for bit.
/// Rows whose time is not later than the same tool's last written one are left out, as scoring leaves them
/// out.
std::string writeTraceCsv(const TraceRows& rows);

/// Row by row, for exports too long to hold: the header line, then each row. Both end in '\n'.
std::string traceCsvHeader(const TraceColumns& columns);
void appendTraceCsvRow(std::string& out, const TraceColumns& columns, const TraceRow& row);

} // namespace chiron::scoring
