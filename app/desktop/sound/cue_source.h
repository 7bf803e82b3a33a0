// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/cue_synthesiser.h"
#include "realtime/latest_value.h"

#include <QIODevice>

namespace chiron::desktop {

/// An endless stream of 16-bit samples, generated from the newest cues, that an audio sink reads.
/// Thread: audio; takes no locks.
class CueSource final : public QIODevice {
public:
    CueSource(realtime::LatestValue<SoundCues>& cues, int rate_Hz, int channels);

    bool isSequential() const override { return true; }
    qint64 bytesAvailable() const override;

protected:
    qint64 readData(char* data, qint64 bytes) override;
    qint64 writeData(const char*, qint64) override { return -1; }

private:
    static constexpr int kBlock = 256; ///< samples between two reads of the cues

    realtime::LatestValue<SoundCues>& m_cues;
    CueSynthesiser m_synthesiser;
    int m_channels;
};

} // namespace chiron::desktop
