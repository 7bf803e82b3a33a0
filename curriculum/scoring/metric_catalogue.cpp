// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metric_catalogue.h"

#include "curriculum/exercises/elastic_tube/scoring/tube_metrics.h"
#include "curriculum/exercises/elastic_tube/scoring/tube_reasons.h"
#include "curriculum/exercises/object_handling/scoring/handling_metrics.h"
#include "curriculum/exercises/object_handling/scoring/handling_reasons.h"
#include "curriculum/exercises/palpation/scoring/palpation_metrics.h"
#include "curriculum/exercises/palpation/scoring/palpation_reasons.h"
#include "curriculum/exercises/sphere_apex/scoring/apex_metrics.h"
#include "curriculum/exercises/sphere_apex/scoring/apex_reasons.h"
#include "curriculum/exercises/urethra_insertion/scoring/canal_metrics.h"
#include "curriculum/exercises/urethra_insertion/scoring/canal_reasons.h"
#include "scoring/metrics/metric_rows.h"

#include <vector>

namespace chiron::scoring {

std::span<const MetricDefinition> metricCatalogue() {
    static const std::vector<MetricDefinition> metrics = [] {
        std::vector<MetricDefinition> all;
        for (const auto subject : {motionMetrics, forceMetrics, torqueMetrics, canalMetrics, outcomeMetrics,
                                   tubeMetrics, handlingMetrics, predictionMetrics, palpationDetectionMetrics,
                                   palpationFindingsMetrics, palpationSearchMetrics, apexMetrics})
            for (MetricDefinition& metric : subject())
                all.push_back(std::move(metric));
        return all;
    }();
    return metrics;
}

std::span<const UndefinedReason> undefinedReasons() {
    static const std::vector<UndefinedReason> every = [] {
        std::vector<UndefinedReason> all;
        using List = std::span<const UndefinedReason>;
        for (const List list : {List(kSharedReasons), List(kApexReasons), List(kCanalReasons),
                                List(kTubeReasons), List(kHandlingReasons), List(kPalpationReasons)})
            all.insert(all.end(), list.begin(), list.end());
        return all;
    }();
    return every;
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
