// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/trace.h"

namespace chiron::scoring {

/// The grids of stored channels: whole µs, nm, mN, 0.01 mN·m and µ° (the last for angles that are derived from
/// stored poses). q/10^n is the double nearest to the decimal a file writes, so writing and reading changes no
/// bit. Idempotent.
double onMicroseconds(double t_s);
double onNanometres(double x_m);
double onMillinewtons(double f_N);
double onTorqueGrid(double torque_Nm);
double onMicrodegrees(double angle_rad);

/// A copy with every value on its grid and, per tool, strictly increasing time: a sample whose time is not
/// later than the last kept one (a packet read twice) or that is not finite is left out, of the insertion
/// series and the quantities too. Whoever cuts a recording into trials leaves such samples out before cutting, so that an exported
/// recording cuts alike. The time at which a landmark was seen becomes that of the first sample then or later.
/// Failure: vectors of unequal length, an insertion series or quantities without tool 0, more than kMostLandmarks landmarks.
core::Result<SessionTrace> onStoredGrids(const SessionTrace& trace);

} // namespace chiron::scoring
