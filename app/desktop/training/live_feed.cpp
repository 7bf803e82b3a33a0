// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/live_feed.h"

namespace chiron::desktop {

core::Result<std::unique_ptr<LiveFeed>> LiveFeed::start(database::Database& database,
                                                        const database::Actor& actor,
                                                        session::TrainingRequest request) {
    std::unique_ptr<LiveFeed> feed(new LiveFeed);
    feed->m_samples.reserve(session::LiveLink::kSamples);
    auto training = session::LiveTraining::start(database, actor, std::move(request), [to = feed.get()] {
        QMetaObject::invokeMethod(
            to,
            [to] {
                to->tick(); // shows the last state before the end is reported
                to->m_timer.stop();
                emit to->finished();
            },
            Qt::QueuedConnection);
    });
    CHIRON_TRY(training);
    feed->m_training = std::move(*training);
    feed->m_timer.setTimerType(Qt::PreciseTimer);
    connect(&feed->m_timer, &QTimer::timeout, feed.get(), &LiveFeed::tick);
    feed->m_timer.start(kFrame_ms);
    return feed;
}

LiveFeed::~LiveFeed() = default;

void LiveFeed::tick() {
    m_training->beat();
    m_training->display().read(m_state);
    m_samples.clear();
    for (session::LiveSample sample;
         m_samples.size() < m_samples.capacity() && m_training->samples().tryPop(sample);) {
        m_samples.push_back(sample);
        m_contacts += (sample.events & core::event_bits::kContactBegan) != 0 ? 1 : 0;
        m_worked_ms += sample.paused || sample.phase == core::TrialPhase::idle ? 0 : 1;
    }
    emit frame();
}

} // namespace chiron::desktop
