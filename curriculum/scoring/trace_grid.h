// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/trace.h"

namespace chiron::scoring {

/// Round to the grids of stored channels: whole µs, nm, mN, 0.01 mN·m and µ° (the last for angles derived
/// from stored poses). q/10^n is the double nearest to the decimal that a file contains, so writing and
/// reading changes no bit. Idempotent.
double onMicroseconds(double t_s);
double onNanometres(double x_m);
double onMillinewtons(double f_N);
double onTorqueGrid(double torque_Nm);
double onMicrodegrees(double angle_rad);

/// Returns a copy with every value on its grid and, per tool, strictly increasing time. A sample whose time
/// is not later than the last kept one (a packet that was read twice), or is not finite, is left out, also
/// from the exercise's own part and the quantities. Code that cuts a recording into trials removes such
/// samples before cutting, so that an exported recording is cut in the same way. Errors: vectors of unequal
/// length, an own part or quantities without tool 0, those of OwnTrace::onGrids.
core::Result<SessionTrace> onStoredGrids(const SessionTrace& trace);

} // namespace chiron::scoring
