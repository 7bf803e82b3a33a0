// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

namespace chiron::database {

/// A live source (the drain of a crash ring) that the writer empties every 20 ms. Called on the writer thread
/// only; writes through its recording::TrialSink. After an error it is asked again, so it must have kept what it
/// could not write; an error that stays is handed out by WriterThread::removeSource.
class IDrainable {
public:
    virtual ~IDrainable() = default;
    virtual core::Result<void> drain() = 0;
};

} // namespace chiron::database
