// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/visible_cues.h"
#include "cues/laparoscopy_cues.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"

#include <vector>

namespace chiron::tests {

/// Everything that a screen is told at a tick, one number after the other, always as many.
inline void addCueNumbers(std::vector<double>& out, const core::VisibleCues& cues) {
    const auto one = [&out](auto value) { out.push_back(static_cast<double>(value)); };
    const auto all = [&one](const auto& values) {
        for (const auto& value : values)
            one(value);
    };
    one(cues.trial);
    one(cues.phase);
    one(cues.force);
    one(cues.timeLeft_s);
    one(cues.objectShown);
    all(std::array<double, 3>{cues.p_WObject.x(), cues.p_WObject.y(), cues.p_WObject.z()});
    one(cues.objectRadius_m);
    one(cues.shownForce_N);

    const simulation::EndoscopeCues& e = cues.exercise.of<simulation::EndoscopeCues>();
    one(e.present);
    one(e.pictureShown);
    one(e.guided);
    one(e.stage);
    one(e.depth_m);
    all(e.toLumen_T);
    one(e.lumenDistance_m);
    one(e.landmarkShown);
    all(e.toLandmark_T);
    one(e.landmarks);
    one(e.landmarksSeen);
    one(e.dwell);

    const core::LaparoscopyCues& l = cues.exercise.of<core::LaparoscopyCues>();
    one(l.present);
    one(l.objectShown);
    one(l.step);
    one(l.dwell);
    one(l.bodies);
    for (const core::BodyCue& body : l.body) {
        all(body.p_W);
        all(body.q_W);
        one(body.radius_m);
        one(body.heldBy);
        one(body.squeeze_m);
    }
    one(l.tube);
    one(l.grips);
    for (const auto& place : l.p_WGrip)
        all(place);
    all(l.gripAt);
    all(l.gripHeldBy);
    all(l.gripAnchored);
    one(l.restLength_m);
    one(l.stretch_m);
    one(l.torn);
    one(l.tensionShown);
    one(l.tension_N);
    one(l.bandLow_N);
    one(l.bandHigh_N);
    one(l.fold);
    all(l.p_WFoldEdge);
    all(l.p_WFoldBase);
    one(l.foldHeldBy);
    one(l.foldOpen);
    one(l.retractionShown);
    one(l.retraction_N);
    one(l.retractionLow_N);
    one(l.retractionHigh_N);
    one(l.targetShown);
    all(l.p_WTarget);
    one(l.targetRadius_m);
    one(l.squeezeShown);
    all(l.squeeze_N);
    one(l.squeezeLimit_N);

    const simulation::PalpationCues& p = cues.exercise.of<simulation::PalpationCues>();
    one(p.present);
    for (const simulation::Finding& finding : p.finding) {
        one(finding.present);
        all(finding.p_W);
        one(finding.radius_m);
        one(finding.hardness);
        one(finding.confidence);
    }
    one(p.selected);
    one(p.asksSize);
    one(p.asksHardness);
    one(p.asksConfidence);
    one(p.lumps);
    for (const simulation::LumpCue& lump : p.lump) {
        all(lump.p_W);
        one(lump.radius_m);
    }
    one(p.coverageShown);
    one(p.coverage);
    one(p.bandShown);
    one(p.bandLow_N);
    one(p.bandHigh_N);
    all(p.depth_m);
    all(p.lean_rad);
    one(p.leanSaturated);
    one(p.squeezeShown);
    all(p.squeeze_N);
}

} // namespace chiron::tests
