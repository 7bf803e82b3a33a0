// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/trace_rows.h"

#include <string>
#include <string_view>

namespace chiron::scoring {

/// Reads a trace file's text (cli.md, Trace files):
/// `t_s,x_mm,y_mm,z_mm[,qw,qx,qy,qz][,jaw_deg][,buttons][,tool]
/// [,fx_N,fy_N,fz_N]` and the columns of our own export (trace_columns.cpp, README), in any order. The format
/// is UTF-8, with comma as separator and a decimal point in any locale, and LF or CRLF. A byte order mark and
/// empty lines at the end are accepted. Times are rounded to whole µs, positions to nm, forces to mN, torques
/// to 0.01 mN·m (trace_grid.h). Nothing is repaired.
/// Errors: badInput as `name:line:column: "value": expected ...`.
core::Result<TraceRows> readTraceCsv(std::string_view text, const std::string& name);

/// Reads a file with readTraceCsv; refuses files over 2 GiB.
/// Errors: notFound or badInput.
core::Result<TraceRows> readTraceCsvFile(const std::string& path);

/// Writes the same format with exact decimals (whole µs, nm, mN, 0.01 mN·m), so that reading gives the same
/// doubles bit for bit. A row whose time is not later than that of the same tool's last written row is left
/// out, as in scoring.
std::string writeTraceCsv(const TraceRows& rows);

/// Write row by row, for exports that do not fit into memory: first the header line, then each row. Both end
/// in '\n'.
std::string traceCsvHeader(const TraceColumns& columns);
void appendTraceCsvRow(std::string& out, const TraceColumns& columns, const TraceRow& row);

} // namespace chiron::scoring
