// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/series_maker.h"

#include "recording/digest.h"
#include "session/device_time.h"

#include <QCryptographicHash>
#include <algorithm>
#include <cmath>

namespace chiron::session_report {

using namespace report;

namespace {

constexpr int kFramesPerPoint = 10; // 1 kHz -> 100 Hz, as the metrics see it

double normOf(const core::Array6& wrench) { return std::hypot(wrench[0], wrench[1], wrench[2]); }

/// Adds up frames to points of the series.
class SeriesBuilder {
public:
    explicit SeriesBuilder(const session::StoredSession& session)
        : m_positions(session.positions()), m_felt(session.record().setup.felt) {}

    void add(const core::HapticFrame& frame) {
        const core::ToolFrame& tool = frame.tool[0];
        const double t_s = m_time.at(frame);
        noteEvents(frame, t_s);
        notePause(frame.header.paused != 0, t_s);
        m_tissue = std::max(m_tissue, normOf(tool.tissue));
        m_commanded = std::max(m_commanded, normOf(tool.commanded));
        m_measured = std::max(m_measured, normOf(tool.measured));
        m_measures = m_measures || (tool.status & core::sample_status::kMeasuredForce) != 0;
        if (++m_inPoint == kFramesPerPoint)
            closePoint(tool, t_s);
    }

    SampleSeries take() {
        if (m_paused && !m_series.t_s.empty())
            m_series.paused.push_back({m_pauseBegan_s, m_series.t_s.back()});
        if (!m_measures)
            m_series.measured_N.clear();
        if (!m_felt)
            m_series.commanded_N.clear(); // nothing was commanded that could be felt
        addSpeed();
        return std::move(m_series);
    }

private:
    void closePoint(const core::ToolFrame& tool, double t_s) {
        const core::Vec3 p = m_positions.p_WT_m(0, tool);
        m_series.t_s.push_back(t_s);
        m_series.x_mm.push_back(p.x() * 1e3);
        m_series.y_mm.push_back(p.y() * 1e3);
        m_series.z_mm.push_back(p.z() * 1e3);
        m_series.tissue_N.push_back(m_tissue);
        m_series.commanded_N.push_back(m_commanded);
        m_series.measured_N.push_back(m_measured);
        m_tissue = m_commanded = m_measured = 0.0;
        m_inPoint = 0;
    }

    void notePause(bool paused, double t_s) {
        if (paused && !m_paused)
            m_pauseBegan_s = t_s;
        if (!paused && m_paused)
            m_series.paused.push_back({m_pauseBegan_s, t_s});
        m_paused = paused;
    }

    void noteEvents(const core::HapticFrame& frame, double t_s) {
        const QString number = QString::number(frame.header.trial + 1);
        if (frame.header.events & core::event_bits::kTrialStarted)
            m_series.events.push_back({t_s, number});
    }

    /// Central differences over 40 ms: what a person would call the speed, without the encoder's steps.
    void addSpeed() {
        const std::size_t n = m_series.t_s.size();
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t a = i >= 2 ? i - 2 : 0;
            const std::size_t b = std::min(i + 2, n - 1);
            const double dt = m_series.t_s[b] - m_series.t_s[a];
            const double d = std::hypot(m_series.x_mm[b] - m_series.x_mm[a], m_series.y_mm[b] - m_series.y_mm[a],
                                        m_series.z_mm[b] - m_series.z_mm[a]);
            m_series.speed_mm_per_s.push_back(dt > 0.0 ? d / dt : 0.0);
        }
    }

    const session::ToolPositions& m_positions;
    SampleSeries m_series;
    session::DeviceTime m_time;
    int m_inPoint = 0;
    double m_tissue = 0.0, m_commanded = 0.0, m_measured = 0.0;
    bool m_felt;
    bool m_measures = false;
    bool m_paused = false;
    double m_pauseBegan_s = 0.0;
};

} // namespace

core::Result<SampleSeries> makeSeries(session::StoredSession& session, QString& recordingDigest) {
    SeriesBuilder builder(session);
    QCryptographicHash hash(QCryptographicHash::Blake2b_256);
    for (std::size_t i = 0; i < session.reader().chunkCount(); ++i) {
        auto frames = session.reader().framesOf(i);
        if (!frames)
            return tl::unexpected(frames.error());
        for (const core::HapticFrame& frame : *frames)
            builder.add(frame);
        auto digest = session.reader().forceHash(i);
        if (!digest)
            return tl::unexpected(digest.error());
        hash.addData(QByteArrayView(reinterpret_cast<const char*>(digest->data()), qsizetype(digest->size())));
    }
    recordingDigest = QString::fromLatin1(hash.result().toHex());
    return builder.take();
}

} // namespace chiron::session_report
