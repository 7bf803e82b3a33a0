// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sound/plugin/audio_sink_output.h"

#include <QAudioSink>
#include <QEventLoop>

namespace chiron::desktop {

namespace {

constexpr qint64 kBuffer_us = 30'000; // short enough that a click coincides with its contact

QAudioFormat formatFor(const QAudioDevice& device) {
    QAudioFormat format = device.preferredFormat();
    format.setSampleFormat(QAudioFormat::Int16);
    if (format.sampleRate() <= 0)
        format.setSampleRate(48'000);
    if (format.channelCount() <= 0)
        format.setChannelCount(2);
    return format;
}

} // namespace

AudioSinkOutput::AudioSinkOutput(const QAudioDevice& device) {
    m_thread.reset(QThread::create([this, device] {
        const QAudioFormat format = formatFor(device);
        CueSource source(m_cues, format.sampleRate(), format.channelCount());
        QAudioSink sink(device, format);
        sink.setBufferSize(format.bytesForDuration(kBuffer_us));
        source.open(QIODevice::ReadOnly);
        sink.start(&source);
        m_works.store(sink.error() == QAudio::NoError, std::memory_order_relaxed);
        QObject::connect(&sink, &QAudioSink::stateChanged, &sink, [&](QAudio::State) {
            if (sink.error() == QAudio::OpenError || sink.error() == QAudio::FatalError ||
                sink.error() == QAudio::IOError)
                m_works.store(false, std::memory_order_relaxed);
        });
        QEventLoop().exec();
        sink.stop();
    }));
    m_thread->start();
}

AudioSinkOutput::~AudioSinkOutput() {
    m_thread->quit();
    m_thread->wait();
}

} // namespace chiron::desktop
