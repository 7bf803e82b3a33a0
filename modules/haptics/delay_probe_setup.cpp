// SPDX-License-Identifier: GPL-3.0-or-later
// Making the scene allocates its record and ending it frees memory, so both are kept apart from the code that the tick calls.
#include "haptics/delay_probe.h"

namespace chiron::haptics {

DelayProbe::DelayProbe(const DelayProbeSettings& settings, DelayRecord& record) : m_settings(settings), m_record(record) {
    m_record.reserve(settings.bursts);
}

DelayProbe::~DelayProbe() = default;
DelayListener::~DelayListener() = default;

} // namespace chiron::haptics
