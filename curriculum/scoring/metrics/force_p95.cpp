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
#include "scoring/metrics/force_samples.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace chiron::scoring {

namespace {

Measurement measureForceP95(std::span<const PreparedTrial> trials) {
    std::vector<double> forces_N;
    forEachForce(trials, [&](double f_N, double) { forces_N.push_back(f_N); });
    if (forces_N.empty())
        return noSamples();
    std::sort(forces_N.begin(), forces_N.end());
    const double place = 0.95 * static_cast<double>(forces_N.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, forces_N.size() - 1);
    return Measurement::of(forces_N[below] +
                           (place - static_cast<double>(below)) * (forces_N[above] - forces_N[below]));
}

/// The load below which 95 % of the time of touching lies.
Measurement measureForceP95Of2(std::span<const PreparedTrial> trials) {
    std::vector<std::pair<double, double>> loads; // N, s
    double time_s = 0.0;
    forEachLoad(trials, [&](double load_N, double held_s, bool touched) {
        if (touched && held_s > 0.0) {
            loads.emplace_back(load_N, held_s);
            time_s += held_s;
        }
    });
    if (loads.empty())
        return Measurement::undefined(UndefinedReason::noContact);
    std::sort(loads.begin(), loads.end());
    double below_s = 0.0;
    for (const auto& [load_N, held_s] : loads)
        if ((below_s += held_s) >= 0.95 * time_s)
            return Measurement::of(load_N);
    return Measurement::of(loads.back().first);
}

} // namespace

MetricDefinition forceP95Metric() { if (chiron_mutants::on(7)) {
    return {.id = "force_p95",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .needsForces = false,
            .definition = "95th percentile of |f| over all samples, linear between order statistics.",
            .source = "models.md §6; Hyndman & Fan 1996, definition 7",
            .measure = measureForceP95};
} else {
    return {.id = "force_p95",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .needsForces = true,
            .definition = "95th percentile of |f| over all samples, linear between order statistics.",
            .source = "models.md §6; Hyndman & Fan 1996, definition 7",
            .measure = measureForceP95};
} }

MetricDefinition forceP95Metric2() {
    MetricDefinition metric = forceP95Metric();
    metric.version = 2;
    metric.tools = MetricTools::all;
    metric.definition = "Load |f| under which 95 % of the time lies for which a tool touches (over 0.02 N); broken tissue counts with the force that broke it.";
    metric.source = "models.md §6; data.md, Range of a law";
    metric.measure = measureForceP95Of2;
    return metric;
}

} // namespace chiron::scoring
