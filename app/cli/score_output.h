// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command_spec.h"
#include "scoring/score_card.h"
#include "session/score_json.h"

#include <QJsonArray>
#include <QJsonObject>

namespace chiron::cli {

/// How one trial ended.
struct TrialEnding {
    QString state;
    bool marked = false; ///< true also if the trial's procedure was completed; if false, the last position is
                         ///< scored and the trial is flagged
    bool timedOut = false;
    bool failed = false;     ///< the trial could not be continued (the object tore)
    bool unfinished = false; ///< the trial had no end and is not part of any score
};

/// The values that `train`, `session show` and `score` print about one session.
struct ScoreView {
    qint64 sessionId = 0;
    QString state;
    scoring::ScoreCard card;
    std::vector<TrialEnding> trials;
    QJsonObject loop;      ///< ticks, late, p50_us, p99_us, max_us
    QJsonObject recording; ///< frames, dropped, bytes
};

using session::metricsJson;

/// Returns [{trial, metrics, marked, timed_out, failed, state, flag}]. The flag is "unfinished" if the trial
/// had no end and is not part of any score, "failed" if the trial could not be done to its end, "no_mark" if
/// the last position is scored in place of a mark, and null otherwise. Trials whose ending is not known have
/// only trial number and metrics.
QJsonArray trialsJson(const scoring::ScoreCard& card, const std::vector<TrialEnding>& endings);
/// One line about flagged trials, as text; empty if there are none.
QString flaggedText(const std::vector<TrialEnding>& endings);
/// The keys that cli.md specifies for `train`: session_id, state, passed, metrics, trials, loop, recording.
QJsonObject scoreJson(const ScoreView& view);
/// The same as text.
QString scoreText(const ScoreView& view);
QString metricsText(const std::vector<scoring::MetricValue>& metrics);

} // namespace chiron::cli
