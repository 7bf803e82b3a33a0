// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

namespace chiron::database {

/// A live source (the drain of a crash ring) that the writer empties every 20 ms. It writes through its
/// recording::TrialSink. After an error it is called again, so it must have kept what it could not write;
/// WriterThread::removeSource reports an error that persists.
/// Thread: only the writer thread.
class IDrainable {
public:
    virtual ~IDrainable() = default;
    virtual core::Result<void> drain() = 0;
};

} // namespace chiron::database
