// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/sphere_apex/scoring/apex_metrics.h"

#include "curriculum/exercises/sphere_apex/scoring/apex_answer.h"
#include "curriculum/exercises/sphere_apex/scoring/apex_reasons.h"
#include "scoring/median.h"
#include "scoring/metrics/metric_rows.h"

#include <algorithm>
#include <cmath>

namespace chiron::scoring {

namespace {

/// Absolute error of an answer on each axis, % of R.
struct OffBy {
    double x = 0.0;
    double y = 0.0;
};

OffBy asMarked(const ApexAnswer& answer) {
    return {std::abs(answer.errorX_percent), std::abs(answer.errorY_percent)};
}
OffBy missesCounted(const ApexAnswer& answer) {
    return {answer.countedX_percent(), answer.countedY_percent()};
}

double sumOf(const std::vector<ApexAnswer>& answers, OffBy (*offBy)(const ApexAnswer&)) {
    double sum = 0.0;
    for (const ApexAnswer& answer : answers) {
        const OffBy off = offBy(answer);
        sum += off.x + off.y;
    }
    return sum;
}

template <OffBy (*offBy)(const ApexAnswer&)>
Measurement measureErrorMean(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    return Measurement::of(sumOf(all.answers, offBy) / (2.0 * static_cast<double>(all.answers.size())));
}

template <OffBy (*offBy)(const ApexAnswer&)>
Measurement measureErrorSd(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    if (all.answers.size() < 2)
        return Measurement::undefined(reasons::kNeedsTwoTrials);
    const double n = 2.0 * static_cast<double>(all.answers.size());
    const double mean = sumOf(all.answers, offBy) / n;
    double squares = 0.0;
    for (const ApexAnswer& answer : all.answers) {
        const OffBy off = offBy(answer);
        squares += std::pow(off.x - mean, 2) + std::pow(off.y - mean, 2);
    }
    return Measurement::of(std::sqrt(squares / (n - 1.0)));
}

template <double ApexAnswer::*error> Measurement measureBias(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    double sum = 0.0;
    for (const ApexAnswer& answer : all.answers)
        sum += answer.*error;
    return Measurement::of(sum / static_cast<double>(all.answers.size()));
}

/// The median of the true positions is the best constant answer.
Measurement measureApexErrorMeanByChance(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    std::vector<double> x_m, y_m;
    for (const PreparedTrial& trial : trials) {
        if (!trial.trial->target || !(trial.trial->target->radius_m > 0.0))
            return Measurement::undefined(reasons::kApexUnknown);
        x_m.push_back(trial.trial->target->x_m);
        y_m.push_back(trial.trial->target->y_m);
    }
    if (trials.size() < 2)
        return Measurement::undefined(reasons::kOneTrialHasNoChance);
    const double bestX_m = median(x_m), bestY_m = median(y_m);
    double sum = 0.0;
    for (const PreparedTrial& trial : trials) {
        const TargetTruth& truth = *trial.trial->target;
        sum += (std::abs(truth.x_m - bestX_m) + std::abs(truth.y_m - bestY_m)) / truth.radius_m;
    }
    return Measurement::of(100.0 * sum / (2.0 * static_cast<double>(trials.size())));
}

Measurement measureApexMisses(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    return Measurement::of(static_cast<double>(
        std::count_if(all.answers.begin(), all.answers.end(), [](const ApexAnswer& a) { return a.miss; })));
}

/// P2, "Preliminary Validation": 14.2 % mean, SD 11.3, five subjects with ten hemispheres each.
constexpr PublishedBand kFivePeople{14.2 - 11.3, 14.2 + 11.3,
                                    QT_TRANSLATE_NOOP("Metrics", "published, 5 subjects × 10")};

} // namespace

std::vector<MetricDefinition> apexMetrics() {
    MetricRows rows;
    rows.add(
        {.id = "apex_error_mean",
         .unit = "% of R",
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Apex error, mean"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "How far the marks lay from the highest point, in % of the "
                                                 "radius; the mean over both axes and all trials, misses "
                                                 "included."),
         .titleOfOneTrial = QT_TRANSLATE_NOOP("Metrics", "Apex error"),
         .meaningOfOneTrial =
             QT_TRANSLATE_NOOP("Metrics", "How far the mark lay from the highest point, in % of the radius, "
                                          "averaged over left–right and front–back."),
         .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Apex error"),
         .definition = "Mean of |100 (x - x0)/R| and |100 (y - y0)/R| pooled over both axes and all trials, "
                       "misses included.",
         .source = "models.md §2.3; P2, Preliminary Validation",
         .published = kFivePeople, // the next version counts misses differently
         .measure = measureErrorMean<asMarked>});
    rows.next({.definition = "Mean of |100 (x - x0)/R| and |100 (y - y0)/R| pooled over both axes and all "
                             "trials; a miss counts as an error of R at "
                             "least.",
               .measure = measureErrorMean<missesCounted>});
    rows.add({.id = "apex_error_mean_by_chance",
              .unit = "% of R",
              .direction = Direction::neutral,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Apex error by chance"),
              .meaning =
                  QT_TRANSLATE_NOOP("Metrics", "The apex error of somebody who perceives nothing and always "
                                               "marks the same, best possible place. An error that is not "
                                               "smaller shows no skill."),
              .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Apex error"),
              .definition =
                  "apex_error_mean of one who always marks the same place, the best for this session "
                  "(the median of the apexes): what "
                  "feeling nothing gives.",
              .source = "our definition",
              .measure = measureApexErrorMeanByChance});
    rows.add(
        {.id = "apex_error_sd",
         .unit = "% of R",
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Apex error, standard deviation"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "How much the error differed from mark to mark."),
         .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Apex error"),
         .definition =
             "Sample standard deviation (n - 1) of the absolute errors pooled over both axes and all trials.",
         .source = "models.md §2.3; P2, Preliminary Validation",
         .measure = measureErrorSd<asMarked>});
    rows.next({.direction = Direction::neutral, // a person who always misses by R has a standard deviation of
                                                // 0
               .definition = "Sample standard deviation (n - 1) of the absolute errors pooled over both axes "
                             "and all trials; a miss counts as an "
                             "error of R at least.",
               .measure = measureErrorSd<missesCounted>});
    rows.add(
        {.id = "apex_bias_x",
         .unit = "% of R",
         .direction = Direction::neutral,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Apex bias, left to right"),
         .meaning = QT_TRANSLATE_NOOP(
             "Metrics",
             "Whether the marks lay to one side: the mean error to the right (positive) or left (negative)."),
         .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Apex error"),
         .definition = "Mean of the signed errors 100 (x - x0)/R; nearer zero is better.",
         .source = "models.md §2.3; P2, Preliminary Validation",
         .measure = measureBias<&ApexAnswer::errorX_percent>});
    rows.add(
        {.id = "apex_bias_y",
         .unit = "% of R",
         .direction = Direction::neutral,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Apex bias, front to back"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "Whether the marks lay to one side: the mean error away "
                                                 "from (positive) or towards (negative) the person."),
         .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Apex error"),
         .definition = "Mean of the signed errors 100 (y - y0)/R; nearer zero is better.",
         .source = "models.md §2.3; P2, Preliminary Validation",
         .measure = measureBias<&ApexAnswer::errorY_percent>});
    rows.add(
        {.id = "apex_misses",
         .unit = "count",
         .wrench = MetricWrench::tissue,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Misses"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "Trials marked without touching, marked beside the sphere, "
                                                 "or not marked in time. Their errors count all the same."),
         .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Apex error"),
         .definition = "Trials marked out of contact, marked farther than R from the apex, or not marked in "
                       "time; their errors count all the "
                       "same.",
         .source = "models.md §2.3; P2, Preliminary Validation",
         .measure = measureApexMisses});
    return rows.take();
}

} // namespace chiron::scoring
