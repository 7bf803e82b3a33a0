// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_law.h"

#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "simulation/geometry/urethra/urethra_validity_setup.h"

#include <array>
#include <limits>

namespace chiron::simulation {

namespace {

using core::LawColumn;
using core::LawParameter;

constexpr std::array<LawColumn, 12> kInputs{{{"px_m", "m"},
                                             {"py_m", "m"},
                                             {"pz_m", "m"},
                                             {"ax", "1"},
                                             {"ay", "1"},
                                             {"az", "1"},
                                             {"vx_m_per_s", "m/s"},
                                             {"vy_m_per_s", "m/s"},
                                             {"vz_m_per_s", "m/s"},
                                             {"wx_rad_per_s", "rad/s"},
                                             {"wy_rad_per_s", "rad/s"},
                                             {"wz_rad_per_s", "rad/s"}}};

constexpr std::array<LawColumn, 26> kOutputs{{{"s_m", "m"},
                                              {"ex_m", "m"},
                                              {"en_m", "m"},
                                              {"phi_x_rad", "rad"},
                                              {"phi_y_rad", "rad"},
                                              {"normal_N", "N"},
                                              {"friction_N", "N"},
                                              {"viscous_N", "N"},
                                              {"elastic_N", "N"},
                                              {"lateral_x_N", "N"},
                                              {"lateral_y_N", "N"},
                                              {"lateral_z_N", "N"},
                                              {"torque_x_Nm", "N·m"},
                                              {"torque_y_Nm", "N·m"},
                                              {"torque_z_Nm", "N·m"},
                                              {"fx_N", "N"},
                                              {"fy_N", "N"},
                                              {"fz_N", "N"},
                                              {"tx_Nm", "N·m"},
                                              {"ty_Nm", "N·m"},
                                              {"tz_Nm", "N·m"},
                                              {"energy_J", "J"},
                                              {"stiffness_N_per_m", "N/m"},
                                              {"bladder_N", "N"},
                                              {"touching", "1"},
                                              {"wall_damped_N", "N"}}};

/// A number of UrethraAnatomy, Endoscope or UrethraForceSettings, with the name that the table shows.
template <class Owner> struct Field {
    double Owner::*member;
    std::string_view name;
    std::string_view unit;
    double minimum;
    double maximum;
};

constexpr std::array<Field<UrethraAnatomy>, 19> kAnatomy{{
    {&UrethraAnatomy::curvature_per_m, "curvature_per_m", "1/m", 0.1, 100.0},
    {&UrethraAnatomy::zEnd_m, "z_end_m", "m", 0.03, 0.3},
    {&UrethraAnatomy::radius_m, "radius_m", "m", 0.0005, 0.01},
    {&UrethraAnatomy::wallStiffness_N_per_m3, "wall_stiffness_N_per_m3", "N/m³", 0.0, 1e9},
    {&UrethraAnatomy::wallStiffening_per_m, "wall_stiffening_per_m", "1/m", 0.0, 10000.0},
    {&UrethraAnatomy::friction, "friction", "1", 0.0, 2.0},
    {&UrethraAnatomy::viscosity_Ns_per_m2, "viscosity_Ns_per_m2", "N·s/m²", 0.0, 10000.0},
    {&UrethraAnatomy::freeLength_m, "free_length_m", "m", 0.0, 0.3},
    {&UrethraAnatomy::freeBlend_m, "free_blend_m", "m", 0.001, 0.1},
    {&UrethraAnatomy::angularStiffness_Nm_per_rad, "angular_stiffness_Nm_per_rad", "N·m/rad", 0.0, 10.0},
    {&UrethraAnatomy::angularCorner_m, "angular_corner_m", "m", 0.0001, 0.05},
    {&UrethraAnatomy::bladderRadius_m, "bladder_radius_m", "m", 0.01, 0.2},
    {&UrethraAnatomy::bladderStiffness_N_per_m, "bladder_stiffness_N_per_m", "N/m", 0.0, 10000.0},
    {&UrethraAnatomy::bladderOpening_rad, "bladder_opening_rad", "rad", 0.01, 1.5},
    {&UrethraAnatomy::bladderOpeningEdge_rad, "bladder_opening_edge_rad", "rad", 0.001, 1.5},
    {&UrethraAnatomy::freeHold_N_per_m, "free_hold_N_per_m", "N/m", 0.0, 5000.0},
    {&UrethraAnatomy::straight_m, "straight_m", "m", 0.0, 0.2},
    {&UrethraAnatomy::pivotSpan_m, "pivot_span_m", "m", 0.0, 0.2},
    {&UrethraAnatomy::wallRetardation_s, "wall_retardation_s", "s", 0.0, 0.1},
}};
constexpr std::size_t kAnatomyCount = kAnatomy.size();

constexpr std::array<Field<Endoscope>, 3> kEndoscope{{
    {&Endoscope::radius_m, "endoscope_radius_m", "m", 0.0005, 0.01},
    {&Endoscope::beak_m, "beak_m", "m", 0.001, 0.05},
    {&Endoscope::behind_m, "behind_m", "m", 0.001, 0.2},
}};

constexpr std::array<Field<UrethraForceSettings>, 3> kSettings{{
    {&UrethraForceSettings::maximumStep_m, "step_m", "m", 0.0001, 0.01},
    {&UrethraForceSettings::count_m, "count_m", "m", 0.0, 0.001},
    {&UrethraForceSettings::maximumDamping_Ns_per_m, "maximum_damping_Ns_per_m", "N·s/m", 0.1, 1000.0},
}};

/// One local change, which is off while its length is 0; and the grid: 0 selects the fine one, any other
/// value is the number of P1's drawn sections.
constexpr std::array<LawParameter, 7> kOthers{{
    {"change_length_m", "m", 0.0, 0.0, 0.1},
    {"change_centre_m", "m", 0.080, 0.0, 0.3},
    {"change_edge_m", "m", 0.004, 0.0001, 0.1},
    {"change_radius_m", "m", 0.0015, 0.0005, 0.01},
    {"change_stiffness_factor", "1", 1.0, 0.0, 1000.0},
    {"change_friction_factor", "1", 1.0, 0.0, 100.0},
    {"basic_sections", "1", 0.0, 0.0, 401.0, true},
}};

constexpr std::size_t kEndoscopeFrom = kAnatomyCount;
constexpr std::size_t kSettingsFrom = kEndoscopeFrom + kEndoscope.size();
constexpr std::size_t kOthersFrom = kSettingsFrom + kSettings.size();
constexpr std::size_t kParameterCount = kOthersFrom + kOthers.size();

template <class Owner> constexpr LawParameter described(const Field<Owner>& field) noexcept {
    return {field.name, field.unit, Owner{}.*field.member, field.minimum, field.maximum};
}

constexpr std::array<LawParameter, kParameterCount> kParameters = [] {
    std::array<LawParameter, kParameterCount> all{};
    for (std::size_t i = 0; i < kAnatomyCount; ++i)
        all[i] = described(kAnatomy[i]);
    for (std::size_t i = 0; i < kEndoscope.size(); ++i)
        all[kEndoscopeFrom + i] = described(kEndoscope[i]);
    for (std::size_t i = 0; i < kSettings.size(); ++i)
        all[kSettingsFrom + i] = described(kSettings[i]);
    for (std::size_t i = 0; i < kOthers.size(); ++i)
        all[kOthersFrom + i] = kOthers[i];
    return all;
}();

UrethraAnatomy anatomyFrom(std::span<const double> p) noexcept {
    UrethraAnatomy anatomy;
    for (std::size_t i = 0; i < kAnatomyCount; ++i)
        anatomy.*kAnatomy[i].member = p[i];
    const std::span<const double> change = p.subspan(kOthersFrom);
    if (change[0] > 0.0) {
        anatomy.changeCount = 1;
        anatomy.changes[0] = {change[1], change[0], change[2], change[3], change[4], change[5]};
    }
    return anatomy;
}

Endoscope endoscopeFrom(std::span<const double> p) noexcept {
    Endoscope endoscope;
    for (std::size_t i = 0; i < kEndoscope.size(); ++i)
        endoscope.*kEndoscope[i].member = p[kEndoscopeFrom + i];
    return endoscope;
}

UrethraForceSettings settingsFrom(std::span<const double> p) noexcept {
    UrethraForceSettings settings;
    for (std::size_t i = 0; i < kSettings.size(); ++i)
        settings.*kSettings[i].member = p[kSettingsFrom + i];
    if (const double basic = p[kOthersFrom + 6]; basic >= 2.0) {
        settings.sections = ForceSections::p1Basic;
        settings.basicSections = static_cast<int>(basic);
    }
    return settings;
}

void write(const UrethraResponse& r, std::span<double> out) noexcept {
    const core::Array6 whole = core::toArray(r.wrench_A);
    const std::array<double, kOutputs.size()> values{r.foot.at.s_m,
                                                     r.foot.ex_m,
                                                     r.foot.en_m,
                                                     r.phiX_rad,
                                                     r.phiY_rad,
                                                     r.normal_N,
                                                     r.friction_N,
                                                     r.viscous_N,
                                                     r.elastic_N,
                                                     r.lateral_A.x(),
                                                     r.lateral_A.y(),
                                                     r.lateral_A.z(),
                                                     r.torqueX_Nm,
                                                     r.torqueY_Nm,
                                                     r.torqueZ_Nm,
                                                     whole[0],
                                                     whole[1],
                                                     whole[2],
                                                     whole[3],
                                                     whole[4],
                                                     whole[5],
                                                     r.energy_J,
                                                     r.stiffness_N_per_m,
                                                     r.bladder_A.norm(),
                                                     r.touching ? 1.0 : 0.0,
                                                     r.wallDamped_N};
    for (std::size_t i = 0; i < values.size(); ++i)
        out[i] = values[i];
}

std::string problem(std::span<const double> p, std::span<const double> in) {
    if (const auto problems = urethraProblems(anatomyFrom(p), endoscopeFrom(p), {}); !problems.empty())
        return problems.front().field + ": " + problems.front().reason;
    if (const double basic = p[kOthersFrom + 6]; basic == 1.0)
        return core::lawProblem("basic_sections", basic, "0 for the fine grid, or at least 2");
    return !in.empty() && !(core::Vec3(in[3], in[4], in[5]).norm() > 0.0)
               ? "ax, ay, az 0: expected the endoscope's axis, of any length but 0"
               : "";
}

/// The output is NaN for an endoscope without a direction and for an invalid urethra, as in the laws of
/// geometry.
void evaluate(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const core::Vec3 axis(in[3], in[4], in[5]);
    const double length = axis.norm();
    const UrethraAnatomy anatomy = anatomyFrom(p);
    const Endoscope endoscope = endoscopeFrom(p);
    if (!(length > 0.0) || !urethraProblems(anatomy, endoscope, {}).empty()) {
        for (double& value : out)
            value = std::numeric_limits<double>::quiet_NaN();
        return;
    }
    const UrethraForces forces(anatomy, endoscope, settingsFrom(p));
    write(forces.respond({core::Vec3(in[0], in[1], in[2]), axis / length, core::Vec3(in[6], in[7], in[8]),
                          core::Vec3(in[9], in[10], in[11])}),
          out);
}

constexpr core::LawDescription kLaw{"urethra-force",
                                    "urethra insertion: force and torque on the endoscope, with every term",
                                    "P1 eq. 1-6; models.md §1.2 and §8",
                                    kInputs,
                                    kOutputs,
                                    kParameters,
                                    &evaluate,
                                    &problem};

} // namespace

const core::LawDescription& urethraForceLaw() noexcept {
    return kLaw;
}

} // namespace chiron::simulation
