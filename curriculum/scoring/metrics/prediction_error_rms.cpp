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
#include "scoring/metrics/handling_samples.h"

#include <cmath>

namespace chiron::scoring {

namespace {

/// Root mean square over the samples since an answer to a touch took effect, each answer as often as it stood; mm.
Measurement rootMeanSquare(std::span<const PreparedTrial> trials, std::string_view id) { if (chiron_mutants::on(18)) {
    double sum = 0.0;
    std::size_t count = 0;
    bool known = false;
    for (const PreparedTrial& trial : trials) {
        const QuantityTrace* predicted = quantityOf(trial, "prediction_error_m");
        const QuantityTrace* held = quantityOf(trial, "held_error_m");
        if (predicted == nullptr || held == nullptr)
            continue;
        known = true;
        const QuantityTrace& wanted = id == predicted->id ? *predicted : *held;
        for (std::size_t i = 0; i < wanted.values.size(); ++i)
            if (trial.tool->paused[i] == 0 && (predicted->values[i] > 1.0 || held->values[i] > 0.0)) {
                sum += wanted.values[i] * wanted.values[i];
                ++count;
            }
    }
    if (count == 0)
        return Measurement::undefined(known ? UndefinedReason::nothingPredicted : UndefinedReason::noPrediction);
    return Measurement::of(1e3 * std::sqrt(sum / static_cast<double>(count)));
} else {
    double sum = 0.0;
    std::size_t count = 0;
    bool known = false;
    for (const PreparedTrial& trial : trials) {
        const QuantityTrace* predicted = quantityOf(trial, "prediction_error_m");
        const QuantityTrace* held = quantityOf(trial, "held_error_m");
        if (predicted == nullptr || held == nullptr)
            continue;
        known = true;
        const QuantityTrace& wanted = id == predicted->id ? *predicted : *held;
        for (std::size_t i = 0; i < wanted.values.size(); ++i)
            if (trial.tool->paused[i] == 0 && (predicted->values[i] > 0.0 || held->values[i] > 0.0)) {
                sum += wanted.values[i] * wanted.values[i];
                ++count;
            }
    }
    if (count == 0)
        return Measurement::undefined(known ? UndefinedReason::nothingPredicted : UndefinedReason::noPrediction);
    return Measurement::of(1e3 * std::sqrt(sum / static_cast<double>(count)));
} }

Measurement measurePredictionError(std::span<const PreparedTrial> trials) { return rootMeanSquare(trials, "prediction_error_m"); }
Measurement measureHeldError(std::span<const PreparedTrial> trials) { return rootMeanSquare(trials, "held_error_m"); }

} // namespace

MetricDefinition predictionErrorRmsMetric() {
    return {.id = "prediction_error_rms",
            .version = 1,
            .unit = "mm",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "How far the soft surface under the tool, as it was shown between two updates of the slow model, lay from what the slow model then said; RMS over the updates.",
            .source = "P2, Haptic-Visual Graphic Integration; models.md §2.2, two rates",
            .measure = measurePredictionError};
}

MetricDefinition heldErrorRmsMetric() {
    return {.id = "held_error_rms",
            .version = 1,
            .unit = "mm",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "prediction_error_rms if the last updates had been held, and blended alike, instead of predicted.",
            .source = "P2, Haptic-Visual Graphic Integration; models.md §2.2, two rates",
            .measure = measureHeldError};
}

} // namespace chiron::scoring
