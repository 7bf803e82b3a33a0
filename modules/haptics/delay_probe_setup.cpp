// SPDX-License-Identifier: GPL-3.0-or-later
// The constructor allocates the record and the destructors free memory, so they are kept apart from the code
// that the tick calls.
#include "haptics/delay_probe.h"

namespace chiron::haptics {

DelayProbe::DelayProbe(const DelayProbeSettings& settings, DelayRecord& record)
    : m_settings(settings), m_record(record) {
    m_record.reserve(settings.bursts);
}

DelayProbe::~DelayProbe() = default;
DelayListener::~DelayListener() = default;

} // namespace chiron::haptics
