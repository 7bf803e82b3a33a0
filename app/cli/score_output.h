// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"
#include "scoring/score_card.h"
#include "session/score_json.h"

#include <QJsonArray>
#include <QJsonObject>

namespace chiron::cli {

/// How one trial ended.
struct TrialEnding {
    QString state;
    bool marked = false; ///< or its procedure completed; else its last position is scored, and it is flagged
    bool timedOut = false;
    bool failed = false; ///< it could not be done any more (torn)
    bool unfinished = false; ///< it had no end and is in no score
};

/// What `train`, `session show` and `score` print about one session.
struct ScoreView {
    qint64 sessionId = 0;
    QString state;
    scoring::ScoreCard card;
    std::vector<TrialEnding> trials;
    QJsonObject loop;      ///< ticks, late, p50_us, p99_us, max_us
    QJsonObject recording; ///< frames, dropped, bytes
};

using session::metricsJson;

/// [{trial, metrics, marked, timed_out, failed, state, flag}]; flag is "unfinished" where the trial had no end and is in no score, "failed" where the trial could not be done to its end, "no_mark" where the last position stands for a
/// mark, else null. Trials whose ending is not known have no more than their metrics.
QJsonArray trialsJson(const scoring::ScoreCard& card, const std::vector<TrialEnding>& endings);
/// One line on flagged trials for people; empty where there is none.
QString flaggedText(const std::vector<TrialEnding>& endings);
/// The keys of cli.md's `train`: session_id, state, passed, metrics, trials, loop, recording.
QJsonObject scoreJson(const ScoreView& view);
/// The same for people.
QString scoreText(const ScoreView& view);
QString metricsText(const std::vector<scoring::MetricValue>& metrics);

} // namespace chiron::cli
