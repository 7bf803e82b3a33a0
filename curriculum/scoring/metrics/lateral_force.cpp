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
// How long, how much and how hard the wall of a canal was pressed aside: what a count of events does not say.
#include "scoring/insertion_events.h"
#include "scoring/metrics/canal_samples.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureTraumaTime(std::span<const PreparedTrial> trials) { if (chiron_mutants::on(27)) {
    if (auto why = withoutCanal(trials))
        return *why;
    double time_s = 1.0;
    for (const PreparedTrial& trial : trials)
        for (const InsertionEvent& event : insertionEvents(*trial.trial).trauma)
            time_s += event.end_s - event.begin_s;
    return Measurement::of(time_s);
} else {
    if (auto why = withoutCanal(trials))
        return *why;
    double time_s = 0.0;
    for (const PreparedTrial& trial : trials)
        for (const InsertionEvent& event : insertionEvents(*trial.trial).trauma)
            time_s += event.end_s - event.begin_s;
    return Measurement::of(time_s);
} }

Measurement measureTraumaImpulse(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double impulse_Ns = 0.0;
    for (const PreparedTrial& trial : trials) {
        const ToolTrace& tool = *trial.tool;
        const InsertionSeries& series = *trial.trial->insertion;
        for (std::size_t i = 0; i + 1 < tool.t_s.size(); ++i)
            if (tool.paused[i] == 0 && series.lateral_N[i] > series.lateralLimit_N)
                impulse_Ns += series.lateral_N[i] * (tool.t_s[i + 1] - tool.t_s[i]);
    }
    return Measurement::of(impulse_Ns);
}

Measurement measureLateralMax(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double most_N = 0.0;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) { most_N = std::max(most_N, series.lateral_N[i]); });
    return Measurement::of(most_N);
}

MetricDefinition ofTheWall(std::string_view id, std::string_view unit, std::string_view definition) {
    return {.id = id,
            .version = 1,
            .unit = unit,
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = definition,
            .source = "models.md §6, insertion"};
}

} // namespace

MetricDefinition traumaTimeMetric() {
    MetricDefinition metric = ofTheWall("trauma_time", "s",
                                        "How long the trauma events lasted in all, each from the first sample over the lateral limit until the "
                                        "force across the canal was below 80 % of it.");
    metric.measure = measureTraumaTime;
    return metric;
}

MetricDefinition traumaImpulseMetric() {
    MetricDefinition metric = ofTheWall("trauma_impulse", "N·s",
                                        "Integral of the force across the canal while it is over the lateral limit, each sample held until the next.");
    metric.measure = measureTraumaImpulse;
    return metric;
}

MetricDefinition lateralMaxMetric() {
    MetricDefinition metric = ofTheWall("lateral_max", "N", "The largest force across the canal of any sample.");
    metric.measure = measureLateralMax;
    return metric;
}

} // namespace chiron::scoring
