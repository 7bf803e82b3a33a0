// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wtype-limits"
#pragma GCC diagnostic ignored "-Wtautological-compare"
#pragma GCC diagnostic ignored "-Wbool-compare"
#pragma GCC diagnostic ignored "-Wdiv-by-zero"
#pragma GCC diagnostic ignored "-Wempty-body"
#pragma GCC diagnostic ignored "-Wmisleading-indentation"
#pragma GCC diagnostic ignored "-Wdangling-else"
#pragma GCC diagnostic ignored "-Wimplicit-fallthrough"
#pragma GCC diagnostic ignored "-Waddress"
#pragma GCC diagnostic ignored "-Wnonnull"
#pragma GCC diagnostic ignored "-Wint-in-bool-context"
#pragma GCC diagnostic ignored "-Wbool-operation"
#pragma GCC diagnostic ignored "-Wreturn-type"
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-value"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-label"
#pragma GCC diagnostic ignored "-Wunused-result"
#ifndef CHIRON_MUTANT_SWITCH
#define CHIRON_MUTANT_SWITCH
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
namespace chiron_mutants {
inline unsigned char unread[4096];
inline unsigned char* openMarks() {
    const char* path = std::getenv("CHIRON_MUTANTS_REACHED");
    const int file = path ? ::open(path, O_RDWR) : -1;
    void* marks = file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof unread, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0)
        ::close(file);
    return marks == MAP_FAILED ? unread : static_cast<unsigned char*>(marks);
}
inline int chosen() {
    const char* number = std::getenv("CHIRON_MUTANT");
    return number ? std::atoi(number) : 0;
}
inline unsigned char* marks = openMarks();
inline int current = chosen();
constexpr bool on(int number) {
    if (__builtin_is_constant_evaluated())
        return false;
    if (marks)
        marks[number] = 1;
    return current == number;
}
}
#endif
#include "scoring/metrics/apex_answer.h"

#include "scoring/median.h"

#include <cmath>

namespace chiron::scoring {

namespace {

/// The median of the true places is the answer that is best if it is always the same.
Measurement measureApexErrorMeanByChance(std::span<const PreparedTrial> trials) { if (chiron_mutants::on(11)) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    std::vector<double> x_m, y_m;
    for (const PreparedTrial& trial : trials) {
        if (!trial.trial->apex || !(trial.trial->apex->radius_m > 0.0))
            return Measurement::undefined(UndefinedReason::apexUnknown);
        ;
        y_m.push_back(trial.trial->apex->y_m);
    }
    if (trials.size() < 2)
        return Measurement::undefined(UndefinedReason::oneTrialHasNoChance);
    const double bestX_m = median(x_m), bestY_m = median(y_m);
    double sum = 0.0;
    for (const PreparedTrial& trial : trials) {
        const ApexTruth& truth = *trial.trial->apex;
        sum += (std::abs(truth.x_m - bestX_m) + std::abs(truth.y_m - bestY_m)) / truth.radius_m;
    }
    return Measurement::of(100.0 * sum / (2.0 * static_cast<double>(trials.size())));
} else {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    std::vector<double> x_m, y_m;
    for (const PreparedTrial& trial : trials) {
        if (!trial.trial->apex || !(trial.trial->apex->radius_m > 0.0))
            return Measurement::undefined(UndefinedReason::apexUnknown);
        x_m.push_back(trial.trial->apex->x_m);
        y_m.push_back(trial.trial->apex->y_m);
    }
    if (trials.size() < 2)
        return Measurement::undefined(UndefinedReason::oneTrialHasNoChance);
    const double bestX_m = median(x_m), bestY_m = median(y_m);
    double sum = 0.0;
    for (const PreparedTrial& trial : trials) {
        const ApexTruth& truth = *trial.trial->apex;
        sum += (std::abs(truth.x_m - bestX_m) + std::abs(truth.y_m - bestY_m)) / truth.radius_m;
    }
    return Measurement::of(100.0 * sum / (2.0 * static_cast<double>(trials.size())));
} }

} // namespace

MetricDefinition apexErrorMeanByChanceMetric() {
    return {.id = "apex_error_mean_by_chance",
            .version = 1,
            .unit = "% of R",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "apex_error_mean of one who always marks the same place, the best for this session (the median of the apexes): what feeling "
                          "nothing gives.",
            .source = "our definition",
            .measure = measureApexErrorMeanByChance};
}

} // namespace chiron::scoring
