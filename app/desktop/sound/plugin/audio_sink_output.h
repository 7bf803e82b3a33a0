// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/cue_source.h"
#include "desktop/sound/sound_output.h"

#include <QAudioDevice>
#include <QThread>
#include <atomic>
#include <memory>

namespace chiron::desktop {

/// Plays the cues on a Qt audio sink with a thread of its own, so that a busy window and the sound server
/// cannot block each other.
/// Thread: GUI.
class AudioSinkOutput final : public ISoundOutput {
public:
    explicit AudioSinkOutput(const QAudioDevice& device);
    ~AudioSinkOutput() override; ///< stops the thread

    void set(const SoundCues& cues) noexcept override { m_cues.publish(cues); }
    bool works() const noexcept override { return m_works.load(std::memory_order_relaxed); }

private:
    realtime::LatestValue<SoundCues> m_cues;
    std::atomic<bool> m_works{true};
    std::unique_ptr<QThread> m_thread;
};

} // namespace chiron::desktop
