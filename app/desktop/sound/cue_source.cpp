// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sound/cue_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace chiron::desktop {

CueSource::CueSource(realtime::LatestValue<SoundCues>& cues, int rate_Hz, int channels)
    : m_cues(cues), m_synthesiser(rate_Hz), m_channels(std::max(channels, 1)) {}

qint64 CueSource::bytesAvailable() const {
    return 1 << 16;
}

qint64 CueSource::readData(char* data, qint64 bytes) {
    const qint64 frameSize = m_channels * static_cast<qint64>(sizeof(std::int16_t));
    const qint64 frames = bytes / frameSize;
    std::array<float, kBlock> block;
    char* out = data;
    for (qint64 done = 0; done < frames;) {
        const auto count = static_cast<std::size_t>(std::min<qint64>(kBlock, frames - done));
        m_synthesiser.set(m_cues.latest());
        m_synthesiser.render({block.data(), count});
        for (std::size_t i = 0; i < count; ++i) {
            const auto sample = static_cast<std::int16_t>(std::lround(block[i] * 32767.0f));
            for (int channel = 0; channel < m_channels; ++channel, out += sizeof sample)
                std::memcpy(out, &sample, sizeof sample);
        }
        done += static_cast<qint64>(count);
    }
    return frames * frameSize;
}

} // namespace chiron::desktop
