// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/geometry/urethra/urethra_centreline.h"
#include "support/desktop_fixture.h"

#include <algorithm>

namespace chiron::tests {

/// A way along the middle of the canal, `deep_m` in and out again at 15 mm/s and 100 Hz, looking along the
/// canal; `beside_m` to the side of it.
inline scoring::TraceRows insertionRows(const simulation::UrethraInsertionParameters& p, double deep_m,
                                        double beside_m = 0.0) {
    constexpr double kSpeed_m_per_s = 0.015;
    constexpr double kStart_m = -0.025;
    const simulation::UrethraCentreline line(p.anatomy);
    const double way_s = (deep_m - kStart_m) / kSpeed_m_per_s;
    scoring::TraceRows rows;
    rows.source = "insertion.csv";
    rows.columns.orientation = true;
    for (int i = 0; i <= static_cast<int>(200.0 * way_s); ++i) {
        scoring::TraceRow row;
        row.t_s = 0.01 * i;
        const double s_m = kStart_m + kSpeed_m_per_s * std::min(row.t_s, 2.0 * way_s - row.t_s);
        const simulation::CentrelinePoint at = line.at(s_m);
        row.p_WT_m = p.pose.pointToW(at.p_A + beside_m * core::Vec3::UnitX());
        // T: y up in the picture, looks along -z.
        core::Mat3 axes;
        const core::Vec3 back_W = p.pose.vectorToW(-at.t_A);
        const core::Vec3 right_W = p.pose.vectorToW(at.n_A).cross(back_W);
        axes << right_W, p.pose.vectorToW(at.n_A), back_W;
        row.q_WT = core::Quat(axes);
        rows.rows.push_back(row);
    }
    return rows;
}

/// A urethra insertion of a level as it is shipped, in the name of a person as by their own hand, as fast as
/// the machine can.
inline database::SessionId addInsertion(DesktopFixture& desktop, const std::string& person, int level = 1,
                                        double deep_m = 0.065, double beside_m = 0.0) {
    const catalogue::ExerciseLevel* shipped =
        desktop.context.site().catalogue().find("urethra_insertion", level);
    if (!shipped)
        qFatal("no level %d of urethra_insertion", level);
    session::TrainingRequest request;
    request.level = *shipped;
    request.ringFolder = recording::defaultRingFolder();
    const auto& parameters = shipped->parameters.as<simulation::UrethraInsertionParameters>();
    auto station =
        session::traceStation(insertionRows(parameters, deep_m, beside_m), session::PointerTool::endoscope);
    if (!station)
        qFatal("%s", station.error().message.c_str());
    request.station = std::move(*station);
    request.station.operatorName.clear();
    auto result = session::runTraining(desktop.database(), desktop.actor(person), std::move(request));
    if (!result)
        qFatal("%s", result.error().message.c_str());
    return result->session;
}

} // namespace chiron::tests
