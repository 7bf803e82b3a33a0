// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/urethra/evaluate_urethra_geometry.h"

#include "core/units.h"
#include "simulation/geometry/urethra/urethra_centreline.h"
#include "simulation/geometry/urethra/urethra_curve_net.h"
#include "simulation/geometry/urethra/urethra_validity_setup.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <algorithm>
#include <array>
#include <limits>

namespace chiron::simulation {

namespace {

using core::LawColumn;
using core::LawParameter;

constexpr LawColumn kArcLength{"s_m", "m"};
constexpr LawParameter kCurvature{"curvature_per_m", "1/m", UrethraAnatomy{}.curvature_per_m, 0.1, 100.0};
constexpr LawParameter kEnd{"z_end_m", "m", UrethraAnatomy{}.zEnd_m, 0.01, 0.3};
constexpr LawParameter kStraight{"straight_m", "m", UrethraAnatomy{}.straight_m, 0.0, 0.2};

void giveUp(std::span<double> out) noexcept {
    std::fill(out.begin(), out.end(), std::numeric_limits<double>::quiet_NaN());
}

// ---- urethra-centreline ----
constexpr std::array<LawColumn, 1> kLineInputs{{kArcLength}};
constexpr std::array<LawColumn, 5> kLineOutputs{
    {{"z_m", "m"}, {"y_m", "m"}, {"psi_rad", "rad"}, {"curvature_per_m", "1/m"}, {"to_neck_m", "m"}}};
constexpr std::array<LawParameter, 3> kLineParameters{{kCurvature, kEnd, kStraight}};

void evaluateLine(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    if (!(p[1] > p[2]))
        return giveUp(out);
    const UrethraCentreline line(p[0], p[1], p[2]);
    const CentrelinePoint at = line.at(in[0]);
    out[0] = at.z_m;
    out[1] = at.p_A.y();
    out[2] = at.psi_rad;
    out[3] = at.curvature_per_m;
    out[4] = line.length_m() - in[0];
}

// ---- shared by profile and surface: wall, endoscope, one local change (none while its length is 0), tip
// ----
constexpr std::size_t kWallCount = 17;
constexpr std::array<LawParameter, kWallCount> kWallParameters{{
    kCurvature,
    kEnd,
    {"radius_m", "m", UrethraAnatomy{}.radius_m, 0.0005, 0.01},
    {"wall_stiffness_N_per_m3", "N/m³", UrethraAnatomy{}.wallStiffness_N_per_m3, 0.0, 1e9},
    {"friction", "1", UrethraAnatomy{}.friction, 0.0, 2.0},
    {"free_length_m", "m", UrethraAnatomy{}.freeLength_m, 0.0, 0.3},
    {"free_blend_m", "m", UrethraAnatomy{}.freeBlend_m, 0.001, 0.1},
    {"endoscope_radius_m", "m", Endoscope{}.radius_m, 0.0005, 0.01},
    {"beak_m", "m", Endoscope{}.beak_m, 0.001, 0.05},
    {"behind_m", "m", Endoscope{}.behind_m, 0.001, 0.2},
    {"change_length_m", "m", 0.0, 0.0, 0.1},
    {"change_centre_m", "m", 0.080, 0.0, 0.3},
    {"change_edge_m", "m", 0.004, 0.0001, 0.1},
    {"change_radius_m", "m", 0.0015, 0.0005, 0.01},
    {"change_stiffness_factor", "1", 1.0, 0.0, 1000.0},
    {"change_friction_factor", "1", 1.0, 0.0, 100.0},
    kStraight,
}};

UrethraAnatomy anatomyFrom(std::span<const double> p) noexcept {
    UrethraAnatomy anatomy;
    anatomy.curvature_per_m = p[0];
    anatomy.zEnd_m = p[1];
    anatomy.radius_m = p[2];
    anatomy.wallStiffness_N_per_m3 = p[3];
    anatomy.friction = p[4];
    anatomy.freeLength_m = p[5];
    anatomy.freeBlend_m = p[6];
    // The laws evaluated here need no torques and no bladder, so their values must not cause a refusal
    anatomy.angularCorner_m = std::min(1e-4, p[5]);
    anatomy.bladderRadius_m = 1.0;
    anatomy.straight_m = p[16];
    if (p[10] > 0.0) {
        anatomy.changeCount = 1;
        anatomy.changes[0] = {p[11], p[10], p[12], p[13], p[14], p[15]};
    }
    return anatomy;
}

Endoscope endoscopeFrom(std::span<const double> p) noexcept {
    Endoscope endoscope;
    endoscope.radius_m = p[7];
    endoscope.beak_m = p[8];
    endoscope.behind_m = p[9];
    return endoscope;
}

template <std::size_t Count>
constexpr std::array<LawParameter, kWallCount + Count>
withWall(const std::array<LawParameter, Count>& more) noexcept {
    std::array<LawParameter, kWallCount + Count> all{};
    std::copy(kWallParameters.begin(), kWallParameters.end(), all.begin());
    std::copy(more.begin(), more.end(), all.begin() + kWallCount);
    return all;
}

constexpr LawParameter kTip{"tip_s_m", "m", 0.060, -1.0, 1.0};

// ---- urethra-profile ----
constexpr std::array<LawColumn, 1> kProfileInputs{{kArcLength}};
constexpr std::array<LawColumn, 7> kProfileOutputs{{{"radius_m", "m"},
                                                    {"opened_radius_m", "m"},
                                                    {"wall_stiffness_N_per_m3", "N/m³"},
                                                    {"friction", "1"},
                                                    {"opening", "1"},
                                                    {"following", "1"},
                                                    {"constrained", "1"}}};
constexpr auto kProfileParameters = withWall(std::array<LawParameter, 1>{{kTip}});

void evaluateProfile(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const UrethraWall wall(anatomyFrom(p), endoscopeFrom(p));
    if (!urethraProblems(wall.anatomy(), wall.endoscope(), {}).empty())
        return giveUp(out);
    const double s = in[0];
    const double tip = p[kWallCount];
    const std::array<double, 7> values{
        wall.radius_m(s),     wall.openedRadius_m(s, tip), wall.stiffness_N_per_m3(s), wall.friction(s),
        wall.opening(s, tip), wall.following(s, tip),      wall.constrained(s)};
    std::copy(values.begin(), values.end(), out.begin());
}

// ---- urethra-surface ----
constexpr std::array<LawColumn, 2> kSurfaceInputs{{kArcLength, {"angle_rad", "rad"}}};
constexpr std::array<LawColumn, 6> kSurfaceOutputs{
    {{"x_m", "m"}, {"y_m", "m"}, {"z_m", "m"}, {"nx", "1"}, {"ny", "1"}, {"nz", "1"}}};
/// `inside` 0: the resting surface. The numbers of the grid are whole numbers.
constexpr auto kSurfaceParameters = withWall(std::array<LawParameter, 7>{{
    kTip,
    {"inside", "1", 0.0, 0.0, 1.0, true},
    {"ex_m", "m", 0.0, -0.02, 0.02},
    {"en_m", "m", 0.0, -0.02, 0.02},
    {"n", "1", 17.0, 5.0, 129.0, true},
    {"w", "1", 26.0, 4.0, 401.0, true},
    {"moving_sections", "1", 9.0, 3.0, 33.0, true},
}});

UrethraMeshSettings meshFrom(std::span<const double> p) noexcept {
    const std::span<const double> own = p.subspan(kWallCount);
    return {static_cast<int>(own[4]), static_cast<int>(own[5]), 1, static_cast<int>(own[6])};
}

void evaluateSurface(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const UrethraAnatomy anatomy = anatomyFrom(p);
    const Endoscope endoscope = endoscopeFrom(p);
    const std::span<const double> own = p.subspan(kWallCount);
    const UrethraMeshSettings mesh = meshFrom(p);
    if (!urethraProblems(anatomy, endoscope, mesh).empty())
        return giveUp(out);
    UrethraCurveNet net(anatomy, endoscope, mesh);
    if (!(in[0] >= 0.0 && in[0] <= net.centreline().length_m()))
        return giveUp(out);
    net.deform({own[1] >= 0.5, own[0], own[2], own[3]});
    const UrethraSurfacePoint point = net.at(in[0], in[1]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        out[axis] = point.p_A[static_cast<Eigen::Index>(axis)];
        out[3 + axis] = point.n_A[static_cast<Eigen::Index>(axis)];
    }
}

std::string wallProblem(std::span<const double> p, const UrethraMeshSettings& mesh) {
    const auto problems = urethraProblems(anatomyFrom(p), endoscopeFrom(p), mesh);
    return problems.empty() ? std::string() : problems.front().field + ": " + problems.front().reason;
}

std::string profileProblem(std::span<const double> p, std::span<const double>) {
    return wallProblem(p, {});
}

std::string surfaceProblem(std::span<const double> p, std::span<const double> in) {
    if (std::string problem = wallProblem(p, meshFrom(p)); !problem.empty() || in.empty())
        return problem;
    const double length_m = UrethraCentreline(anatomyFrom(p)).length_m();
    return in[0] >= 0.0 && in[0] <= length_m
               ? std::string()
               : core::lawProblem("s_m", in[0],
                                  "from 0 to the bladder neck, " + std::to_string(length_m) + " m");
}

constexpr core::LawDescription kLine{
    "urethra-centreline",
    "centre-line of the urethra, straight and then y = c (z - straight)^2, by arc length",
    "P1; models.md §1.1 and §8",
    kLineInputs,
    kLineOutputs,
    kLineParameters,
    &evaluateLine};
constexpr core::LawDescription kProfile{
    "urethra-profile",
    "wall of the urethra along its centre-line, at rest and with the endoscope in it",
    "P1; models.md §1.1 and §1.2",
    kProfileInputs,
    kProfileOutputs,
    kProfileParameters,
    &evaluateProfile,
    &profileProblem};
constexpr core::LawDescription kSurface{"urethra-surface",
                                        "drawn surface of the urethra, moved by the tip's offset in its free "
                                        "and its constrained part alike: point "
                                        "and normal at arc length and angle, in A",
                                        "P1 §3; models.md §1.1",
                                        kSurfaceInputs,
                                        kSurfaceOutputs,
                                        kSurfaceParameters,
                                        &evaluateSurface,
                                        &surfaceProblem};

} // namespace

const core::LawDescription& urethraCentrelineLaw() noexcept {
    return kLine;
}

const core::LawDescription& urethraProfileLaw() noexcept {
    return kProfile;
}

const core::LawDescription& urethraSurfaceLaw() noexcept {
    return kSurface;
}

} // namespace chiron::simulation
