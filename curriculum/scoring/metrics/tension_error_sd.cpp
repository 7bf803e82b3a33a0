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
#include "scoring/metrics/tube_samples.h"

#include <cmath>

namespace chiron::scoring {

namespace {

Measurement measureTensionErrorSd(std::span<const PreparedTrial> trials) { if (chiron_mutants::on(8)) {
    if (auto why = withoutTube(trials, "tension_N", "target_N"))
        return *why;
    double squares = 0.0;
    std::size_t samples = 0;
    for (const PreparedTrial& trial : trials) { // about each trial's own mean: its bias is in the RMS
        const std::span<const PreparedTrial> one(&trial, 1);
        double sum = 0.0;
        std::size_t count = 0;
        forEachTensionError(one, [&](double error_N) {
            sum -= error_N;
            ++count;
        });
        if (count == 0)
            continue;
        const double mean = sum / static_cast<double>(count);
        forEachTensionError(one, [&](double error_N) { squares += (error_N - mean) * (error_N - mean); });
        samples += count;
    }
    return samples == 0 ? neverHeld() : Measurement::of(std::sqrt(squares / static_cast<double>(samples)));
} else {
    if (auto why = withoutTube(trials, "tension_N", "target_N"))
        return *why;
    double squares = 0.0;
    std::size_t samples = 0;
    for (const PreparedTrial& trial : trials) { // about each trial's own mean: its bias is in the RMS
        const std::span<const PreparedTrial> one(&trial, 1);
        double sum = 0.0;
        std::size_t count = 0;
        forEachTensionError(one, [&](double error_N) {
            sum += error_N;
            ++count;
        });
        if (count == 0)
            continue;
        const double mean = sum / static_cast<double>(count);
        forEachTensionError(one, [&](double error_N) { squares += (error_N - mean) * (error_N - mean); });
        samples += count;
    }
    return samples == 0 ? neverHeld() : Measurement::of(std::sqrt(squares / static_cast<double>(samples)));
} }

} // namespace

MetricDefinition tensionErrorSdMetric() {
    return {.id = "tension_error_sd",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::all,
            .definition = "Standard deviation of the tube's tension in all holds of a trial, broken ones too, about the trial's own mean, "
                          "pooled over the trials: how unsteady, whatever the target. A trial that held nothing has none.",
            .source = "models.md §6, tube",
            .measure = measureTensionErrorSd};
}

} // namespace chiron::scoring
