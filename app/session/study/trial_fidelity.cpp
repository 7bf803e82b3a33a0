// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/trial_fidelity.h"

#include "session/study/fidelity_sample.h"
#include "simulation/comparison/comparison_scene.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>

namespace chiron::session {

namespace {

QJsonValue number(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue();
}

QJsonObject placeJson(const PlaceFidelity& p) {
    return {{"place", p.place},
            {"asked", number(p.asked)},
            {"rendered", number(p.rendered)},
            {"standard_error", number(p.standardError)},
            {"contacts", p.contacts},
            {"contact_s", number(p.contact_s)},
            {"peak_force_N", number(p.peakForce_N)},
            {"mean_speed_m_per_s", number(p.meanSpeed_m_per_s)},
            {"terminal_force_N", number(p.terminalForce_N)}};
}

QJsonObject apexJson(const ApexMark& mark) {
    return {{"error_x_m", number(mark.errorX_m)},
            {"error_y_m", number(mark.errorY_m)},
            {"radius_m", number(mark.radius_m)},
            {"in_contact", mark.inContact},
            {"planned", mark.planned}};
}

template <class Whole> Whole whole(double value) noexcept {
    return static_cast<Whole>(value + 0.5);
}

} // namespace

double pausedOf(const std::string& fidelityJson) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(fidelityJson))
        .object()["paused_s"]
        .toDouble(TrialFidelity::kNone);
}

TrialFidelity withoutForces(TrialFidelity fidelity) {
    fidelity.forceErrorRms_N = fidelity.saturated = fidelity.peakForce_N = fidelity.stiffnessError =
        std::nan("");
    fidelity.places.clear();
    fidelity.apex.reset();
    fidelity.outside.clear();
    return fidelity;
}

std::string fidelityJson(const TrialFidelity& f) {
    QJsonArray places;
    for (const PlaceFidelity& place : f.places)
        places.append(placeJson(place));
    QJsonObject json{{"force_error_rms_N", number(f.forceErrorRms_N)},
                     {"measured", f.rendered() ? QJsonValue(f.measured) : QJsonValue()},
                     {"shown", f.shown},
                     {"late_ticks", number(f.lateTicks)},
                     {"worst_lateness_us", number(f.worstLateness_us)},
                     {"saturated", number(f.saturated)},
                     {"duration_s", number(f.duration_s)},
                     {"paused_s", number(f.paused_s)},
                     {"peak_force_N", number(f.peakForce_N)},
                     {"mean_speed_m_per_s", number(f.meanSpeed_m_per_s)},
                     {"contacts", f.rendered() ? QJsonValue(f.contacts) : QJsonValue()},
                     {"stiffness_error", number(f.stiffnessError)},
                     {"places", places},
                     {"outside", QString::fromStdString(f.outside)}};
    if (f.apex)
        json.insert("apex", apexJson(*f.apex));
    // Only known values get a key, so that trials without them are stored as before.
    const TrialCircumstances& c = f.circumstances;
    if (!c.language.empty())
        json.insert("language", QString::fromStdString(c.language));
    if (!c.masking.empty())
        json.insert("masking", QString::fromStdString(c.masking));
    if (c.answerTick)
        json.insert("answer_tick", static_cast<qint64>(*c.answerTick));
    return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString(); // QJsonObject sorts its keys
}

TrialCircumstances circumstancesOf(const std::string& fidelityJson) {
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(fidelityJson)).object();
    TrialCircumstances out;
    out.language = json["language"].toString().toStdString();
    out.masking = json["masking"].toString().toStdString();
    if (const qint64 tick = json["answer_tick"].toInteger(-1); tick >= 0)
        out.answerTick = static_cast<std::uint64_t>(tick);
    return out;
}

std::optional<ApexMark> apexMarkOf(const std::string& fidelityJson) {
    const QJsonObject json =
        QJsonDocument::fromJson(QByteArray::fromStdString(fidelityJson)).object()["apex"].toObject();
    const QJsonValue x = json["error_x_m"], y = json["error_y_m"];
    if (!x.isDouble() || !y.isDouble())
        return std::nullopt;
    return ApexMark{x.toDouble(), y.toDouble(), json["radius_m"].toDouble(), json["in_contact"].toBool(),
                    json["planned"].toBool()};
}

FidelitySample fidelitySampleOf(const core::HapticFrame& frame) noexcept {
    namespace q = simulation::comparison_quantity;
    const core::TickHeader& header = frame.header;
    const core::ToolFrame& tool = frame.tool[0];
    FidelitySample out;
    out.tick = header.index;
    out.now_ns = header.now_ns;
    out.events = header.events;
    out.guards = header.guards;
    out.trial = header.trial;
    out.phase = header.phase;
    out.paused = header.paused;
    out.full = header.force == core::ForceState::on;
    out.measures = (tool.status & core::sample_status::kMeasuredForce) != 0;
    out.saturated =
        (tool.status & core::sample_status::kSaturated) != 0 || (header.guards & core::guard_bits::kCap) != 0;
    out.place = whole<std::uint8_t>(header.quantities[q::kPlace]);
    out.touched = whole<std::uint8_t>(header.quantities[q::kTouched]);
    out.candidate = whole<std::uint16_t>(header.quantities[q::kCandidate]);
    out.arrangement = whole<std::uint16_t>(header.quantities[q::kArrangement]);
    out.answer = whole<std::uint16_t>(header.quantities[q::kAnswer]);
    out.displacement_m = header.quantities[q::kDisplacement];
    out.depth_m = header.quantities[q::kDepth];
    for (std::size_t i = 0; i < 3; ++i) {
        out.velocity_m_per_s[i] = header.quantities[q::kVelocity + i];
        out.commanded_N[i] = tool.commanded[i];
        out.measured_N[i] = tool.measured[i];
        out.tissue_N[i] = tool.tissue[i];
    }
    return out;
}

} // namespace chiron::session
