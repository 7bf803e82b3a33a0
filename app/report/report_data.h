// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace chiron::report {

class ReportSection;

/// One line of the metrics table; numbers in the metric's own unit, as people read them.
struct MetricRow {
    QString id;   ///< snake_case, stored token
    QString name; ///< display name; the id where empty
    QString unit; ///< "%", "mm", "N"; empty for none
    std::optional<double> value;
    QString reason;                    ///< why there is no value
    std::optional<double> gateMinimum; ///< pass mark, inclusive
    std::optional<double> gateMaximum;
    std::optional<bool> passed;    ///< only where gated
    bool headline = false;         ///< shown large on the first page; at most three are
    std::optional<double> bandLow; ///< benchmark band, e.g. a published mean ± SD
    std::optional<double> bandHigh;
    QString bandSource; ///< where the band is from, e.g. "published, 5 subjects × 10"
    std::optional<double> chance; ///< what somebody reaches who only guesses; absent where guessing has no such value
    std::optional<double> limit{}; ///< below gateMaximum: the limit of the level, over which the pass mark lets it be by a little
    int trials = 0; ///< how many the value is of; 0: not known
};

struct TimeSpan {
    double begin_s = 0.0;
    double end_s = 0.0;
};

struct TimedEvent {
    double t_s = 0.0;
    QString label; ///< short: "trial 3", "mark"
};

/// What one tool did. All vectors have the series' length, except that `measured_N`, `commanded_N` and `speed_mm_per_s` may be empty
/// (not measured, not felt, not stored). Positions in W, forces as norms. Values that are not finite leave a gap.
struct ToolSamples {
    QString name; ///< "Left instrument"; needed only where there are several
    std::vector<double> x_mm, y_mm, z_mm;
    std::vector<double> tissue_N;    ///< what the scene answered: assessed
    std::vector<double> commanded_N; ///< after the supervisor
    std::vector<double> measured_N;  ///< by the device
    std::vector<double> speed_mm_per_s;
};

/// One of the errors that the metric critical_errors counts.
struct CriticalError {
    double begin_s = 0.0;
    double end_s = 0.0; ///< equal to begin_s for a moment
    int trial = 0;      ///< 0-based; people see it 1-based
    int tool = 0;
    QString words; ///< what happened, with its size: "The tissue gave way at 8.00 N"
};

/// The samples of a session (or of one trial) for plots: every tool's, at most four.
struct SampleSeries {
    std::vector<double> t_s; ///< ascending
    std::vector<ToolSamples> tools;
    std::vector<double> offset_mm;     ///< of tool 0 from a canal's centre-line; empty where there is none
    std::vector<double> alignment_deg; ///< between that instrument and the canal; the same
    std::vector<TimeSpan> paused; ///< hatched; left out of every metric
    std::vector<TimedEvent> events;
    std::vector<CriticalError> criticalErrors; ///< by time
};

/// What the loop did, as stored with the session.
struct LoopFacts {
    std::uint64_t ticks = 0;
    std::uint64_t late = 0;
    std::uint64_t skipped = 0; ///< left out: the loop was not there in time
    bool realtime = true; ///< false: ticks ran back to back, lateness has no meaning
    double p50_us = 0.0; ///< of the lateness
    double p99_us = 0.0;
    double max_us = 0.0;
};

/// What makes the report traceable to its recording.
struct IntegrityFacts {
    QString sessionId;
    std::uint64_t frames = 0;
    std::uint64_t dropped = 0;
    std::uint64_t bytes = 0;
    QString buildId;
    QString contentSha256;   ///< of the resolved content, hex
    QString taskSha256;      ///< of the resolved content without its texts, hex: the same for sessions that felt the same and were judged alike; may be empty
    QString recordingDigest; ///< BLAKE2b over the recording, hex
    QString scoreSeal;       ///< BLAKE2b over the stored scores, hex; empty if none are shown
};

/// What tissue answered beside what a hand was given, in the running time of the session's trials.
struct ForceFacts {
    double tissue_N = 0.0; ///< largest, of every tool: what is assessed
    double felt_N = 0.0;   ///< largest commanded
    double limited_s = 0.0; ///< how long any tool was given less than the tissue answered
    std::optional<double> firstLimited_s; ///< when that began first, on the recording's time
    double beyondChecked = 0.0; ///< share of the samples outside the poses and depths for which the law was checked, 0..1
};

/// More of a score's samples than this outside of the checked range, and the score says so (data.md, Range of a law).
inline constexpr double kBeyondCheckedSaid = 0.01;

/// Everything a session report shows. Values only: whoever fills it reads the database, never this module.
struct ReportData {
    QString site;               ///< what the site is called; empty: it has no name
    QString person;             ///< display name, or the operator's ("expert, seed 7")
    bool simulated = false;     ///< a scripted hand, not a person
    bool demonstration = false; ///< the permanent banner of a demonstration database
    QString exerciseTitle;
    QString levelTitle;
    QString exerciseId;
    int level = 1;
    QDateTime startedUtc;  ///< UTC
    int offsetMinutes = 0; ///< local time's offset from UTC when it was recorded
    double duration_s = 0.0;
    QString device;
    bool felt = true;           ///< false: force was shown, not felt
    QString state;              ///< completed, stopped, interrupted, incomplete, faulted, voided
    std::optional<bool> passed; ///< absent where nothing is gated, and where the session did not come to its end
    int trialsDone = 0;         ///< trials that came to an end
    std::vector<MetricRow> metrics; ///< of a session that came to no end, none is judged (`passed`, `headline`)
    std::optional<ForceFacts> force; ///< absent where nothing was recorded
    std::vector<std::shared_ptr<const ReportSection>> sections; ///< what its exercise alone shows, in reading order; none is null
    SampleSeries series;
    double forceLimit_N = 4.0;
    LoopFacts loop;
    IntegrityFacts integrity;
};

/// One operator or group in a comparison: a value per session (e.g. mean apex error in %).
struct ComparisonGroup {
    QString name;
    std::vector<double> values;
};

struct ComparisonData {
    QString title;
    QString metricName;
    QString unit;
    std::vector<ComparisonGroup> groups;
    QString pointLabel;              ///< what a point is: "session", "trial"
    std::optional<double> reference; ///< e.g. 14.2 (P2's mean), drawn as a line
    QString referenceLabel;
};

} // namespace chiron::report
