// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/yield_cause.h"

#include "session/device_time.h"
#include "session/exercise_kind.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace chiron::session {

simulation::YieldLaw yieldLawOf(const catalogue::ExerciseLevel& level) {
    const auto kind = exerciseKind(level.exercise);
    return kind ? (*kind)->yieldLaw(level) : simulation::YieldLaw{};
}

bool gaveWayToTorque(const simulation::YieldLaw& law, double force_N, double torque_Nm) noexcept {
    return torque_Nm / law.torque_Nm > force_N / law.force_N; // 0 if there is no limit
}

YieldCause yieldCauseOf(const simulation::YieldLaw& law, const std::string& detailJson) {
    const QJsonObject detail = QJsonDocument::fromJson(QByteArray::fromStdString(detailJson)).object();
    const double force_N = 1e-3 * detail.value(QLatin1String("force_mN")).toDouble();
    const double torque_mNm = detail.value(QLatin1String("torque_mN_m")).toDouble();
    const bool byTorque = gaveWayToTorque(law, force_N, 1e-3 * torque_mNm);
    return {byTorque, byTorque ? torque_mNm : force_N};
}

std::optional<core::Vec3> yieldPlaceOf(const recording::IPositionOf* positions, int tool,
                                       const core::ToolFrame& frame) noexcept {
    if (positions == nullptr || isRefused(frame))
        return std::nullopt;
    return positions->p_WT_m(tool, frame);
}

} // namespace chiron::session
