// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metric_catalogue.h"

#include <array>

namespace chiron::scoring {

// One line a metric: the function in metrics/<id>.cpp that describes it. A new version of a metric is a line
// beside the old one.
#define CHIRON_METRICS(METRIC)                                                                               \
    METRIC(timeMetric)                                                                                       \
    METRIC(pathLengthMetric)                                                                                 \
    METRIC(pathInefficiencyMetric)                                                                           \
    METRIC(pathInefficiencyMetric2)                                                                          \
    METRIC(pathInefficiencyMetric3)                                                                          \
    METRIC(sparcMetric)                                                                                      \
    METRIC(ldljMetric)                                                                                       \
    METRIC(forceMaxMetric)                                                                                   \
    METRIC(forceMaxMetric2)                                                                                  \
    METRIC(forceMeanMetric)                                                                                  \
    METRIC(forceMeanMetric2)                                                                                 \
    METRIC(forceRmsMetric)                                                                                   \
    METRIC(forceRmsMetric2)                                                                                  \
    METRIC(forceP95Metric)                                                                                   \
    METRIC(forceP95Metric2)                                                                                  \
    METRIC(forcePeakRateMetric)                                                                              \
    METRIC(forceImpulseOverLimitMetric)                                                                      \
    METRIC(forceImpulseOverLimitMetric2)                                                                     \
    METRIC(forceTimeOverLimitMetric)                                                                         \
    METRIC(forceTimeOverLimitMetric2)                                                                        \
    METRIC(offsetRmsMetric)                                                                                  \
    METRIC(offsetMaxMetric)                                                                                  \
    METRIC(alignmentRmsMetric)                                                                               \
    METRIC(bendAlignmentMetric)                                                                              \
    METRIC(curveAlignmentMetric)                                                                             \
    METRIC(advanceWhileTurningMetric)                                                                        \
    METRIC(traumaEventsMetric)                                                                               \
    METRIC(traumaTimeMetric)                                                                                 \
    METRIC(traumaImpulseMetric)                                                                              \
    METRIC(lateralMaxMetric)                                                                                 \
    METRIC(torqueMaxMetric)                                                                                  \
    METRIC(torqueRmsMetric)                                                                                  \
    METRIC(reversalsMetric)                                                                                  \
    METRIC(landmarksSeenMetric)                                                                              \
    METRIC(procedureCompletedMetric)                                                                         \
    METRIC(procedureCompletedMetric2)                                                                        \
    METRIC(inspectionTravelMetric)                                                                           \
    METRIC(insertionDepthMetric)                                                                             \
    METRIC(tensionErrorRmsMetric)                                                                            \
    METRIC(tensionErrorSdMetric)                                                                             \
    METRIC(timeInBandMetric)                                                                                 \
    METRIC(retractionTimeInBandMetric)                                                                       \
    METRIC(retractionMaxMetric)                                                                              \
    METRIC(overStretchesMetric)                                                                              \
    METRIC(dropsMetric)                                                                                      \
    METRIC(squeezeMaxMetric)                                                                                 \
    METRIC(squeezeTimeOverLimitMetric)                                                                       \
    METRIC(placementErrorMetric)                                                                             \
    METRIC(weighingCorrectMetric)                                                                            \
    METRIC(weighingCorrectByChanceMetric)                                                                    \
    METRIC(predictionErrorRmsMetric)                                                                         \
    METRIC(heldErrorRmsMetric)                                                                               \
    METRIC(criticalErrorsMetric)                                                                             \
    METRIC(criticalErrorsMetric2)                                                                            \
    METRIC(palpationHitsMetric)                                                                              \
    METRIC(palpationHitsMetric2)                                                                             \
    METRIC(palpationMissesMetric)                                                                            \
    METRIC(palpationMissesMetric2)                                                                           \
    METRIC(palpationFalseAlarmsMetric)                                                                       \
    METRIC(palpationDPrimeMetric)                                                                            \
    METRIC(palpationDPrimeMetric2)                                                                           \
    METRIC(palpationDPrimeLowMetric)                                                                         \
    METRIC(palpationDPrimeHighMetric)                                                                        \
    METRIC(palpationCriterionMetric)                                                                         \
    METRIC(palpationCriterionMetric2)                                                                        \
    METRIC(palpationRocAreaMetric)                                                                           \
    METRIC(palpationRocAreaMetric2)                                                                          \
    METRIC(localisationErrorMetric)                                                                          \
    METRIC(localisationErrorByChanceMetric)                                                                  \
    METRIC(sizeErrorMetric)                                                                                  \
    METRIC(sizeErrorByChanceMetric)                                                                          \
    METRIC(sizeErrorByChanceMetric2)                                                                         \
    METRIC(hardnessOrderMetric)                                                                              \
    METRIC(hardnessOrderMetric2)                                                                             \
    METRIC(hardnessOrderByChanceMetric)                                                                      \
    METRIC(coverageMetric)                                                                                   \
    METRIC(forceBandTimeMetric)                                                                              \
    METRIC(pressingTimeMetric)                                                                               \
    METRIC(searchingTimeMetric)                                                                              \
    METRIC(apexErrorMeanMetric)                                                                              \
    METRIC(apexErrorMeanMetric2)                                                                             \
    METRIC(apexErrorMeanByChanceMetric)                                                                      \
    METRIC(apexErrorSdMetric)                                                                                \
    METRIC(apexErrorSdMetric2)                                                                               \
    METRIC(apexBiasXMetric)                                                                                  \
    METRIC(apexBiasYMetric)                                                                                  \
    METRIC(apexMissesMetric)

#define CHIRON_DECLARE_METRIC(function) MetricDefinition function();
#define CHIRON_CALL_METRIC(function) function(),

CHIRON_METRICS(CHIRON_DECLARE_METRIC)

std::span<const MetricDefinition> metricCatalogue() {
    static const auto kMetrics = std::to_array<MetricDefinition>({CHIRON_METRICS(CHIRON_CALL_METRIC)});
    return kMetrics;
}

const MetricDefinition* findMetric(std::string_view id, int version) {
    const MetricDefinition* found = nullptr;
    for (const MetricDefinition& metric : metricCatalogue())
        if (metric.id == id &&
            (version == 0 ? found == nullptr || metric.version > found->version : metric.version == version))
            found = &metric;
    return found;
}

} // namespace chiron::scoring
