// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <cmath>

namespace chiron::testing {

/// Evenly spaced, both ends included.
inline std::vector<double> spaced(double first, double last, int count) {
    std::vector<double> out;
    for (int i = 0; i < count; ++i)
        out.push_back(first + (last - first) * i / (count - 1));
    return out;
}

/// Differences of a threshold study in log10 units: geometric from 0.01 to `last`.
inline std::vector<double> candidates(double last = 0.30, int count = 30) {
    std::vector<double> out;
    for (int i = 0; i < count; ++i)
        out.push_back(0.01 * std::pow(last / 0.01, static_cast<double>(i) / (count - 1)));
    return out;
}

inline psychophysics::Rank3Spec rank3(const std::vector<double>& differences, int most = 80, int fewest = 20,
                                      double sd = 0.06) {
    psychophysics::Rank3Spec spec;
    spec.differences = differences;
    spec.log10Sigma = spaced(-2.6, -0.4, 111);
    spec.stop = {.trials = most, .minimumTrials = fewest, .sd = sd};
    return spec;
}

/// A reference and what the objects otherwise are, of each rendered attribute.
inline psychophysics::StimulusDesign stimulusOf(psychophysics::Attribute attribute) {
    using psychophysics::Attribute;
    psychophysics::StimulusDesign s;
    s.attribute = attribute;
    s.differences = candidates();
    switch (attribute) {
    case Attribute::stiffness:
        s.reference = 150.0;
        s.fixed = {{"viscosity_Ns_per_m", 0.5}};
        break;
    case Attribute::mass:
        s.reference = 0.05;
        s.fixed = {{"stiffness_N_per_m", 300.0}, {"damping_Ns_per_m", 2.0}};
        break;
    case Attribute::deformation:
        s.reference = 0.08;
        s.fixed = {{"stiffness_N_per_m", 250.0}, {"recovery_share", 1.0}, {"damping_Ns_per_m", 0.5}};
        break;
    case Attribute::roughness:
        s.reference = 100e-6;
        s.fixed = {
            {"stiffness_N_per_m", 650.0}, {"roughness_wavelength_m", 0.003}, {"damping_Ns_per_m", 1.0}};
        break;
    case Attribute::friction:
        s.reference = 0.25;
        s.fixed = {{"stiffness_N_per_m", 400.0}, {"damping_Ns_per_m", 1.0}};
        break;
    case Attribute::viscosity:
        s.reference = 4.0;
        s.fixed = {{"stiffness_N_per_m", 400.0}, {"damping_Ns_per_m", 1.0}};
        break;
    case Attribute::apex:
        break;
    }
    return s;
}

/// A study of one condition, "main": rank-3 QUEST+ on an attribute, as quick as simulated participants can
/// be.
inline psychophysics::StudyDesign
rank3Study(psychophysics::Attribute attribute = psychophysics::Attribute::stiffness, int most = 80,
           int fewest = 20, double sd = 0.06) {
    psychophysics::StudyDesign design;
    design.id = "end_to_end";
    design.title = {{"en", "End to end"}};
    design.objective = design.instructions = design.consent = {{"en", "A test."}};
    psychophysics::Condition condition;
    condition.id = "main";
    condition.title = {{"en", "Main"}};
    condition.stimulus = stimulusOf(attribute);
    condition.task = psychophysics::Task::rank3;
    condition.procedures = {rank3(condition.stimulus.differences, most, fewest, sd)};
    design.conditions = {condition};
    design.trial.betweenTrials_s = 0.05;
    design.trial.practiceTrials = 0;
    design.trial.breakEvery = 0;
    design.trial.exploreLimit_s = 25.0;
    return design;
}

/// The same as P2 did it: three presentations a level, from large to small, until two of three fail.
inline psychophysics::StudyDesign
descendingStudy(psychophysics::Attribute attribute = psychophysics::Attribute::stiffness) {
    psychophysics::StudyDesign design = rank3Study(attribute);
    psychophysics::Condition& condition = design.conditions.front();
    condition.stimulus.differences.clear();
    for (double log10D = -2.0; log10D < -0.39; log10D += 0.1)
        condition.stimulus.differences.push_back(std::pow(10.0, log10D));
    psychophysics::DescendingSpec spec;
    spec.levels.assign(condition.stimulus.differences.rbegin(), condition.stimulus.differences.rend());
    condition.procedures = {spec};
    return design;
}

} // namespace chiron::testing
