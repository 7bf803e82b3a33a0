// SPDX-License-Identifier: GPL-3.0-or-later
// Prints what docs/results/study_table.md condenses: study_table noise [trials] | recovery [seeds]
// [attribute] | legacy [seeds] | controls. Asserts nothing.
#include "session/study/rendered_run.h"
#include "support/study_designs.h"

#include "psychophysics/study/attribute.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace chiron;
using psychophysics::Attribute;

namespace {

constexpr Attribute kRendered[] = {Attribute::stiffness, Attribute::mass,     Attribute::deformation,
                                   Attribute::roughness, Attribute::friction, Attribute::viscosity};

constexpr int kFarthest = 29;

double noise(int trials, Attribute attribute, bool print) {
    const auto design = testing::rank3Study(attribute);
    double squares = 0.0;
    int n = 0;
    for (const int candidate : {5, 12, 20, kFarthest}) {
        const auto found = session::renderingNoise(design, "main", candidate, trials, 17);
        if (!found) {
            std::printf("%s\n", found.error().message.c_str());
            return 0.0;
        }
        if (print)
            std::printf("%-12s D %.3f  mean %+.4f %+.4f %+.4f  sd %.4f %.4f %.4f  pooled %.4f  missed %d  "
                        "%.2f s a trial\n",
                        psychophysics::token(attribute).data(),
                        design.conditions[0].stimulus.differences[static_cast<std::size_t>(candidate)],
                        found->mean[0], found->mean[1], found->mean[2], found->sd[0], found->sd[1],
                        found->sd[2], found->pooledSd, found->missed, found->seconds);
        if (candidate == kFarthest)
            continue; // printed only: an adaptive run hardly ever goes there
        squares += found->pooledSd * found->pooledSd;
        ++n;
    }
    return std::sqrt(squares / n);
}

void recovery(int seeds, Attribute attribute, double weber, bool legacy,
              simulation::ComparisonControl control) {
    const double rendering = noise(66, attribute, false); // 198 explorations a level (psychophysics.md §6)
    session::RenderedRunRequest request;
    request.design = legacy ? testing::descendingStudy(attribute) : testing::rank3Study(attribute);
    request.condition = "main";
    request.observer.weber = weber;
    request.observer.lapse = 0.02;
    request.control = control;
    if (control == simulation::ComparisonControl::swapped ||
        control == simulation::ComparisonControl::constant)
        request.design.fidelity.stiffnessError = 10.0; // or fidelity sees it first and spoils every trial
    const double sigma = psychophysics::sigmaOf(request.observer);
    const double truth = std::hypot(sigma, rendering);
    double sum = 0.0, squares = 0.0, ticks = 0.0, trials = 0.0, spoiled = 0.0;
    int inside = 0, known = 0, ruled = 0;
    double rule = 0.0, rule2 = 0.0;
    for (int seed = 1; seed <= seeds; ++seed) {
        request.seed = static_cast<std::uint64_t>(seed);
        const auto run = session::runRendered(request);
        if (!run) {
            std::printf("%s\n", run.error().message.c_str());
            return;
        }
        ticks += static_cast<double>(run->ticks);
        for (const auto& trial : run->trials)
            (trial.spoiled.empty() ? trials : spoiled) += 1.0;
        const auto& e = run->estimate;
        if (legacy && run->threshold > 0.0) {
            const double over = std::log10(run->threshold / std::log10(1.0 + weber));
            rule += over;
            rule2 += over * over;
            ++ruled;
        }
        if (seed <= 3) {
            std::printf("  seed %d sigma %.4f [%.4f, %.4f] trials %d", seed, e.sigma_log10, e.sigma95.low,
                        e.sigma95.high, e.trials);
            for (const auto& w : e.warnings)
                std::printf(" | %s", warningText(w).c_str());
            std::printf(" | last spoiled '%s'\n",
                        run->trials.empty() ? "" : run->trials.back().spoiled.c_str());
        }
        if (!(e.sigma_log10 > 0.0))
            continue;
        ++known;
        inside += e.sigma95.low <= truth && truth <= e.sigma95.high ? 1 : 0;
        const double off = std::log10(e.sigma_log10 / truth);
        sum += off;
        squares += off * off;
    }
    const double mean = sum / std::max(1, known);
    std::printf("%-12s W %.3f sigma %.4f render %.4f truth %.4f | inside %d of %d known %d | log10 error "
                "mean %+.3f sd %.3f | trials %.1f spoiled %.1f"
                " | %.0f s simulated a run\n",
                psychophysics::token(attribute).data(), weber, sigma, rendering, truth, inside, seeds, known,
                mean, std::sqrt(std::max(0.0, squares / std::max(1, known) - mean * mean)), trials / seeds,
                spoiled / seeds, ticks * 1e-3 / seeds);
    if (ruled > 0)
        std::printf("  the rule's own threshold: log10 over the 75 %% JND mean %+.3f sd %.3f, %d runs\n",
                    rule / ruled, std::sqrt(std::max(0.0, rule2 / ruled - rule / ruled * (rule / ruled))),
                    ruled);
}

} // namespace

int main(int argc, char** argv) {
    const char* what = argc > 1 ? argv[1] : "noise";
    const int count = argc > 2 ? std::atoi(argv[2]) : 24;
    const double weber = argc > 4 ? std::atof(argv[4]) : 0.12;
    const auto chosen = argc > 3 ? psychophysics::attributeFromToken(argv[3]) : std::nullopt;
    using simulation::ComparisonControl;
    for (const Attribute attribute : kRendered) {
        if (chosen && *chosen != attribute)
            continue;
        if (std::strcmp(what, "noise") == 0)
            std::printf("%-12s sigma_render %.4f\n", psychophysics::token(attribute).data(),
                        noise(count, attribute, true));
        else if (std::strcmp(what, "recovery") == 0)
            recovery(count, attribute, weber, false, ComparisonControl::none);
        else if (std::strcmp(what, "legacy") == 0)
            recovery(count, attribute, weber, true, ComparisonControl::none);
        else
            for (const auto control :
                 {ComparisonControl::gain, ComparisonControl::swapped, ComparisonControl::constant})
                recovery(count, attribute, weber, false, control);
    }
    return 0;
}
