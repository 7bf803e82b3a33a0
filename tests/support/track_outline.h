// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/session/playback_insertion.h"
#include "session/session_view.h"
#include "session/worst_moment.h"
#include "session_report/mark_words.h"
#include "support/looked_back.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace chiron::tests {

/// What playback shows of a session, as lines: its trials, marks with their words, and of all that changes
/// from sample to sample the mean and the root of the mean square. In thousandths (ms, mm, mN, mrad), so that
/// KeptText::nearly is near enough; places in µm.
class TrackOutline {
public:
    TrackOutline(const session::PlaybackTrack& track, const catalogue::ExerciseLevel& level,
                 const scoring::ScoreCard& card)
        : m_track(track) {
        m_lines << QStringLiteral("track of %1 %2, felt %3, measures %4, limit %5, %6 tools, %7 moments, %8")
                       .arg(QString::fromStdString(track.exercise))
                       .arg(track.level)
                       .arg(track.felt)
                       .arg(track.measures)
                       .arg(milli(track.forceLimit_N))
                       .arg(track.toolCount)
                       .arg(track.moments.size())
                       .arg(milli(track.duration_s));
        addTrials();
        addMarks(level);
        addMoments();
        addTools();
        addViews();
        if (const auto worst = session::worstMoment(track, card, level.gates))
            m_lines << QStringLiteral("worst at %1, trial %2, %3 of %4, gate %5, unit \"%6\"")
                           .arg(milli(worst->t_s))
                           .arg(worst->trial)
                           .arg(milli(worst->value))
                           .arg(QString::fromStdString(worst->reason))
                           .arg(worst->gateFailed)
                           .arg(QString::fromStdString(worst->unit));
    }
    const QStringList& lines() const { return m_lines; }

private:
    static QString number(double value) {
        return std::isfinite(value) ? QString::number(value, 'f', 2) : QStringLiteral("nothing");
    }
    static QString milli(double value) { return number(1e3 * value); }
    static QString micro(const core::Vec3& p) {
        return number(1e6 * p.x()) + QLatin1Char(' ') + number(1e6 * p.y()) + QLatin1Char(' ') +
               number(1e6 * p.z());
    }
    /// Of what there is: how many, mean, root of the mean square.
    static QString summed(const std::vector<double>& values) {
        double sum = 0.0, squares = 0.0;
        int count = 0;
        for (const double value : values)
            if (std::isfinite(value)) {
                sum += value;
                squares += value * value;
                ++count;
            }
        return count == 0 ? QStringLiteral("none")
                          : QStringLiteral("%1: %2, %3")
                                .arg(count)
                                .arg(milli(sum / count), milli(std::sqrt(squares / count)));
    }
    template <class Of> QString over(int tool, Of of) const {
        std::vector<double> values;
        for (std::size_t i = 0; i < m_track.moments.size(); ++i)
            values.push_back(of(m_track.tool(i, tool)));
        return summed(values);
    }

    void addTrials() {
        for (const session::PlaybackTrial& trial : m_track.trials) {
            m_lines << QStringLiteral("trial %1, %2 to %3, marked %4, completed %5, timed out %6, failed %7, "
                                      "in contact %8, end %9")
                           .arg(trial.index)
                           .arg(milli(trial.start_s), milli(trial.end_s))
                           .arg(trial.marked)
                           .arg(trial.completed)
                           .arg(trial.timedOut)
                           .arg(trial.failed)
                           .arg(trial.endedInContact)
                           .arg(micro(trial.p_WEnd));
            if (trial.object)
                m_lines << QStringLiteral("  object %1, radius %2, turned %3, %4 lumps")
                               .arg(micro(trial.object->p_WObject), milli(trial.object->radius_m),
                                    milli(trial.object->turn_rad))
                               .arg(trial.object->lumps.size());
        }
        for (const session::PlaybackSpan& span : m_track.paused)
            m_lines << QStringLiteral("paused %1 to %2").arg(milli(span.begin_s), milli(span.end_s));
        for (const session::PlaybackPeak& peak : m_track.peaks)
            m_lines << QStringLiteral("peak %1 in trial %2 at %3: %4 %5")
                           .arg(QString::fromStdString(peak.metrics.front()))
                           .arg(peak.trial)
                           .arg(milli(peak.t_s), milli(peak.value), QString::fromStdString(peak.unit));
    }
    void addMarks(const catalogue::ExerciseLevel& level) {
        for (const session::PlaybackMark& mark : m_track.marks)
            m_lines << QStringLiteral(
                           "mark %1, trial %2, tool %3, %4 to %5, critical %6, costs %7, %8, %9 \"%10\"")
                           .arg(QString::fromUtf8(mark.kind.id.data(), qsizetype(mark.kind.id.size())))
                           .arg(mark.trial)
                           .arg(mark.tool)
                           .arg(milli(mark.t_s), milli(mark.end_s))
                           .arg(mark.critical)
                           .arg(session::isPenalty(mark.kind))
                           .arg(mark.value ? milli(*mark.value) : QStringLiteral("no value"),
                                QString::fromStdString(mark.detail),
                                session_report::markText(mark, level.exercise, QLocale::c()));
    }
    void addMoments() {
        std::map<int, int> phases, forces;
        std::vector<double> ticks, trials;
        int paused = 0;
        for (const session::PlaybackMoment& moment : m_track.moments) {
            ++phases[static_cast<int>(moment.phase)];
            ++forces[static_cast<int>(moment.force)];
            paused += moment.paused ? 1 : 0;
            ticks.push_back(1e-3 * static_cast<double>(moment.tick));
            trials.push_back(moment.trial);
        }
        QString line = QStringLiteral("moments: ticks %1; trials %2; paused %3; phases")
                           .arg(summed(ticks), summed(trials))
                           .arg(paused);
        for (const auto& [phase, times] : phases)
            line += QStringLiteral(" %1:%2").arg(phase).arg(times);
        line += QStringLiteral("; force");
        for (const auto& [force, times] : forces)
            line += QStringLiteral(" %1:%2").arg(force).arg(times);
        m_lines << line;
        for (const session::PlaybackQuantity& quantity : m_track.quantities)
            m_lines << QStringLiteral("quantity %1 \"%2\" %3")
                           .arg(QString::fromStdString(quantity.id), QString::fromStdString(quantity.unit),
                                summed(quantity.values));
        const auto* own = m_track.of<session::PlaybackInsertion>();
        if (!own)
            return;
        const session::PlaybackInsertion& insertion = *own;
        m_lines << QStringLiteral("canal %1, bend %2, goal %3, %4 of %5 landmarks")
                       .arg(milli(insertion.length_m), milli(insertion.bend_m), milli(insertion.goal_m))
                       .arg(insertion.landmarksSeen())
                       .arg(insertion.landmarkSeen_s.size());
        std::vector<double> depth, offset, alignment, stage;
        for (const session::PlaybackInsertionMoment& moment : insertion.moments) {
            depth.push_back(moment.depth_m);
            offset.push_back(moment.offset_m);
            alignment.push_back(moment.alignment_rad);
            stage.push_back(static_cast<double>(moment.stage));
        }
        m_lines << QStringLiteral("  depth %1; offset %2; alignment %3; stage %4; seen %5")
                       .arg(summed(depth), summed(offset), summed(alignment), summed(stage),
                            summed(insertion.landmarkSeen_s));
    }
    void addTools() {
        for (int k = 0; k < m_track.toolCount; ++k) {
            using Tool = session::PlaybackTool;
            for (int axis = 0; axis < 3; ++axis)
                m_lines << QStringLiteral("tool %1 axis %2: place %3; surface %4; tissue %5; turned %6")
                               .arg(k)
                               .arg(axis)
                               .arg(over(k, [axis](const Tool& t) { return t.p_WT[axis]; }),
                                    over(k, [axis](const Tool& t) { return t.p_WProxy[axis]; }),
                                    over(k, [axis](const Tool& t) { return t.tissue_N[axis]; }),
                                    over(k, [axis](const Tool& t) { return t.q_WT.vec()[axis]; }));
            m_lines << QStringLiteral("tool %1: commanded %2; measured %3; speed %4; jaw %5; inside %6")
                           .arg(k)
                           .arg(over(k, [](const Tool& t) { return t.commanded_N; }),
                                over(k, [](const Tool& t) { return t.measured_N; }),
                                over(k, [](const Tool& t) { return t.speed_m_per_s; }),
                                over(k, [](const Tool& t) { return t.jaw_rad; }),
                                over(k, [](const Tool& t) { return 1e3 * (t.p_WProxy - t.p_WT).norm(); }));
        }
    }
    /// What is shown between samples: a ninth, a half and a bit, near the end, beyond.
    void addViews() {
        for (const double share : {0.111, 0.5003, 0.9, 1.1}) {
            const double t_s = share * m_track.duration_s;
            const session::PlaybackView view = m_track.at(t_s);
            const session::PlaybackTrial* trial = m_track.trialAt(t_s);
            m_lines << QStringLiteral("at %1: tick %2, trial %3, in %4, paused %5, object %6, back at %7")
                           .arg(milli(t_s))
                           .arg(m_track.tickAt(t_s))
                           .arg(view.moment.trial)
                           .arg(trial ? trial->index : -1)
                           .arg(m_track.pausedAt(t_s))
                           .arg(view.object.has_value())
                           .arg(milli(m_track.timeOfTick(m_track.tickAt(t_s))));
            for (const session::PlaybackTool& tool : view.tools)
                m_lines << QStringLiteral("  %1; %2 mN, %3")
                               .arg(micro(tool.p_WT), milli(tool.tissue_N.norm()), milli(tool.q_WT.w()));
            if (const auto insertion = session::insertionAt(m_track, t_s))
                m_lines << QStringLiteral("  depth %1, offset %2, stage %3")
                               .arg(milli(insertion->depth_m), milli(insertion->offset_m))
                               .arg(static_cast<int>(insertion->stage));
        }
    }

    const session::PlaybackTrack& m_track;
    QStringList m_lines;
};

} // namespace chiron::tests
