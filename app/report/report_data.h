// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::report {

class ReportSection;

/// One line of the metrics table. Numbers are in the metric's own unit, as displayed.
struct MetricRow {
    QString id;   ///< snake_case, stored token
    QString name; ///< display name; if empty, the id is shown
    QString unit; ///< "%", "mm", "N"; empty for none
    std::optional<double> value;
    QString reason;                    ///< why there is no value
    std::optional<double> gateMinimum; ///< pass mark, inclusive
    std::optional<double> gateMaximum;
    std::optional<bool> passed;    ///< only if the metric has a pass mark
    bool headline = false;         ///< shown large on the first page; at most three are
    std::optional<double> bandLow; ///< benchmark band, e.g. a published mean ± SD
    std::optional<double> bandHigh;
    QString bandSource; ///< source of the band, e.g. "published, 5 subjects × 10"
    /// The value that somebody reaches by guessing alone; absent if guessing has no such value.
    std::optional<double> chance;
    /// The limit of the level, if it is below gateMaximum: the pass mark then allows a small excess over this
    /// limit.
    std::optional<double> limit{};
    int trials = 0; ///< number of trials behind the value; 0: not known
};

struct TimeSpan {
    double begin_s = 0.0;
    double end_s = 0.0;
};

struct TimedEvent {
    double t_s = 0.0;
    QString label; ///< short: "trial 3", "mark"
};

/// The samples of one tool. All vectors have the length of the series, except that `measured_N`,
/// `commanded_N` and `speed_mm_per_s` may be empty (not measured, not felt, not stored). Forces are norms.
/// Non-finite values leave a gap.
/// Frame: W for positions.
struct ToolSamples {
    QString name; ///< "Left instrument"; needed only with several tools
    std::vector<double> x_mm, y_mm, z_mm;
    std::vector<double> tissue_N;    ///< response of the scene: the assessed force
    std::vector<double> commanded_N; ///< after the supervisor
    std::vector<double> measured_N;  ///< measured by the device
    std::vector<double> speed_mm_per_s;
};

/// One of the errors counted by the metric critical_errors.
struct CriticalError {
    double begin_s = 0.0;
    double end_s = 0.0; ///< equal to begin_s for an instantaneous error
    int trial = 0;      ///< 0-based; displayed 1-based
    int tool = 0;
    QString words; ///< the error with its size: "The tissue gave way at 8.00 N"
};

/// A series that the exercise derives from the samples, SI; NaN outside of a trial.
struct DerivedSeries {
    std::string id; ///< with its unit: "offset_m"
    std::vector<double> values;
};

/// The samples of a session (or of one trial) for plots, for up to four tools.
struct SampleSeries {
    std::vector<double> t_s; ///< ascending
    std::vector<ToolSamples> tools;
    std::vector<DerivedSeries> derived;
    std::vector<TimeSpan> paused; ///< hatched; excluded from every metric
    std::vector<TimedEvent> events;
    std::vector<CriticalError> criticalErrors; ///< ordered by time

    /// The values of the derived series with this id; empty if there is none.
    std::span<const double> derivedValues(std::string_view id) const noexcept {
        for (const DerivedSeries& series : derived)
            if (series.id == id)
                return series.values;
        return {};
    }
};

/// The statistics of the haptic loop, as stored with the session.
struct LoopFacts {
    std::uint64_t ticks = 0;
    std::uint64_t late = 0;
    std::uint64_t skipped = 0; ///< ticks left out because the loop was late
    bool realtime = true;      ///< false: ticks ran back to back, lateness has no meaning
    double p50_us = 0.0;       ///< of the lateness
    double p99_us = 0.0;
    double max_us = 0.0;
};

/// Data that link the report to its recording.
struct IntegrityFacts {
    QString sessionId;
    std::uint64_t frames = 0;
    std::uint64_t dropped = 0;
    std::uint64_t bytes = 0;
    QString buildId;
    QString contentSha256; ///< of the resolved content, hex
    /// Digest of the resolved content without its texts, hex; equal for sessions that felt the same and were
    /// assessed in the same way. May be empty.
    QString taskSha256;
    QString recordingDigest; ///< BLAKE2b over the recording, hex
    QString scoreSeal;       ///< BLAKE2b over the stored scores, hex; empty if none are shown
};

/// The force of the tissue and the force given to the hand, over the running time of the session's trials.
struct ForceFacts {
    double tissue_N = 0.0;                ///< largest over all tools: the assessed force
    double felt_N = 0.0;                  ///< largest commanded force
    double limited_s = 0.0;               ///< how long any tool was given less than the tissue's force
    std::optional<double> firstLimited_s; ///< when this first began, on the recording's clock
    /// Share of the samples outside the poses and depths for which the law was checked, 0..1.
    double beyondChecked = 0.0;
};

/// If a larger share of a score's samples lies outside the checked range, the report states it
/// (data.md, Range of a law).
inline constexpr double kBeyondCheckedSaid = 0.01;

/// Everything that a session report shows. It holds values only: the caller fills it from the database, which
/// this module does not know.
struct ReportData {
    QString site;               ///< name of the site; empty if it has none
    QString person;             ///< display name, or the scripted operator's ("expert, seed 7")
    bool simulated = false;     ///< a scripted operator, not a person
    bool demonstration = false; ///< shows the permanent banner of a demonstration database
    QString exerciseTitle;
    QString levelTitle;
    QString exerciseId;
    int level = 1;
    QDateTime startedUtc;  ///< UTC
    int offsetMinutes = 0; ///< offset of local time from UTC at the time of recording
    double duration_s = 0.0;
    QString device;
    bool felt = true;           ///< false: force was shown, not felt
    QString state;              ///< completed, stopped, interrupted, incomplete, faulted, voided
    std::optional<bool> passed; ///< absent if no metric has a pass mark, or the session did not reach its end
    int trialsDone = 0;         ///< trials that came to an end
    std::vector<MetricRow> metrics;  ///< for a session that did not reach its end, no metric is judged
                                     ///< (`passed`, `headline`)
    std::optional<ForceFacts> force; ///< absent if nothing was recorded
    /// Sections specific to the exercise, in reading order; none is null.
    std::vector<std::shared_ptr<const ReportSection>> sections;
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
    QString pointLabel;              ///< what a point represents: "session", "trial"
    std::optional<double> reference; ///< e.g. 14.2 (P2's mean), drawn as a line
    QString referenceLabel;
};

} // namespace chiron::report
