// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session_report/metric_words.h"

namespace chiron::desktop {

using session_report::bandSourceText;
using session_report::metricMeaning;
using session_report::metricReason;
using session_report::metricTitle;
using session_report::momentTitle;
using session_report::unitText;

} // namespace chiron::desktop
