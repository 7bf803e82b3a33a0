// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/urethra/urethra_validity_setup.h"

#include "core/units.h"
#include "simulation/geometry/urethra/urethra_centreline.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace chiron::simulation {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kShortestCanal_m =
    0.010; ///< 401 sections of such a canal stay 25 µm apart, far more than the nudge
constexpr double kShortestBeak_m = 0.001;   ///< 33 moving sections stay 31 µm apart
constexpr double kShortestChange_m = 0.010; ///< models.md §1.1: a shorter ring would fall between sections
/// Finer than the edge of the shortest change, so that no bend of the radius is missed.
constexpr int kWallSamples = 1024;

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

class Check {
public:
    std::vector<UrethraProblem> take() { return std::move(m_problems); }
    void add(std::string field, std::string reason) {
        m_problems.push_back({std::move(field), std::move(reason)});
    }
    /// Adds a problem unless `value` is finite and low ≤ value ≤ high (low itself only where `lowAllowed`).
    /// Returns true if it is.
    bool range(const std::string& field, double value, double low, bool lowAllowed, double high = kInfinity) {
        if (std::isfinite(value) && (lowAllowed ? value >= low : value > low) && value <= high)
            return true;
        std::string wanted = (lowAllowed ? "at least " : "more than ") + number(low);
        if (high < kInfinity)
            wanted += " and at most " + number(high);
        add(field, "is " + number(value) + "; it must be " + wanted);
        return false;
    }
    bool positive(const std::string& field, double value) { return range(field, value, 0.0, false); }
    bool notNegative(const std::string& field, double value) { return range(field, value, 0.0, true); }
    bool clean() const { return m_problems.empty(); }

private:
    std::vector<UrethraProblem> m_problems;
};

std::string place(std::size_t i) {
    return "changes[" + std::to_string(i) + "].";
}

void checkWallNumbers(Check& check, const UrethraAnatomy& a) {
    check.positive("radius_m", a.radius_m);
    check.notNegative("wallStiffness_N_per_m3", a.wallStiffness_N_per_m3);
    check.notNegative("wallStiffening_per_m", a.wallStiffening_per_m);
    check.notNegative("friction", a.friction);
    check.notNegative("viscosity_Ns_per_m2", a.viscosity_Ns_per_m2);
    check.notNegative("wallRetardation_s", a.wallRetardation_s);
    check.notNegative("angularStiffness_Nm_per_rad", a.angularStiffness_Nm_per_rad);
}

void checkFreePart(Check& check, const UrethraAnatomy& a, double length_m) {
    if (check.range("freeLength_m", a.freeLength_m, 0.0, true) && a.freeLength_m >= length_m)
        check.add("freeLength_m",
                  "is " + number(a.freeLength_m) + ", but the canal ends at " + number(length_m));
    else if (a.angularCorner_m > 0.0 && a.freeLength_m + 2.0 * a.angularCorner_m > length_m)
        check.add("angularCorner_m", "is " + number(a.angularCorner_m) + ": the rounded corners at " +
                                         number(a.freeLength_m) + " and at the canal's end, " +
                                         number(length_m) + ", run into one another");
    // Before the entrance no body holds the shaft or turns it back (models.md §1.2).
    const bool corner = check.positive("angularCorner_m", a.angularCorner_m);
    if (corner && std::isfinite(a.freeLength_m) && a.angularCorner_m > a.freeLength_m)
        check.add("angularCorner_m", "is " + number(a.angularCorner_m) +
                                         ": a torque outside the body; it must be at most " +
                                         "freeLength_m, " + number(a.freeLength_m));
    if (corner && a.angularCorner_m <= a.freeLength_m && a.straight_m + a.angularCorner_m > a.freeLength_m)
        check.add("straight_m",
                  "is " + number(a.straight_m) +
                      ": the curvature begins there with a jump, and the canal must not turn the shaft " +
                      "yet; it must be at most freeLength_m less angularCorner_m, " +
                      number(a.freeLength_m - a.angularCorner_m));
    check.notNegative("pivotSpan_m", a.pivotSpan_m);
    if (check.positive("freeBlend_m", a.freeBlend_m) && a.freeBlend_m > a.freeLength_m)
        check.add("freeBlend_m", "is " + number(a.freeBlend_m) +
                                     ": the wall's hold would begin at the entrance with a jump; it " +
                                     "must be at most freeLength_m, " + number(a.freeLength_m));
}

bool checkChange(Check& check, const UrethraLocalChange& change, const std::string& at, double length_m) {
    bool good = check.range(at + "length_m", change.length_m, kShortestChange_m, true);
    good &= check.range(at + "edge_m", change.edge_m, 0.0, false, change.length_m);
    good &= check.positive(at + "radius_m", change.radius_m);
    good &= check.notNegative(at + "stiffnessFactor", change.stiffnessFactor);
    good &= check.notNegative(at + "frictionFactor", change.frictionFactor);
    const double reach = 0.5 * (change.length_m + change.edge_m);
    if (good && !(change.centre_m - reach >= 0.0 && change.centre_m + reach <= length_m)) {
        check.add(at + "centre_m", "is " + number(change.centre_m) + ": the change reaches from " +
                                       number(change.centre_m - reach) + " to " +
                                       number(change.centre_m + reach) + ", out of the canal, 0 to " +
                                       number(length_m));
        return false;
    }
    return good;
}

void checkChanges(Check& check, const UrethraAnatomy& a, double length_m) {
    if (a.changeCount > UrethraAnatomy::kMaxChanges) {
        check.add("changeCount", "is " + std::to_string(a.changeCount) + "; it must be at most " +
                                     std::to_string(UrethraAnatomy::kMaxChanges));
        return;
    }
    for (std::size_t i = 0; i < a.changeCount; ++i) {
        if (!checkChange(check, a.changes[i], place(i), length_m))
            continue;
        for (std::size_t other = 0; other < i; ++other) {
            const double apart = std::abs(a.changes[i].centre_m - a.changes[other].centre_m);
            const double reach = 0.5 * (a.changes[i].length_m + a.changes[i].edge_m +
                                        a.changes[other].length_m + a.changes[other].edge_m);
            if (apart < reach)
                check.add(place(i) + "centre_m", "is " + number(apart) + " from that of changes[" +
                                                     std::to_string(other) + "]: they overlap below " +
                                                     number(reach));
        }
    }
}

void checkBladder(Check& check, const UrethraAnatomy& a, const Endoscope& scope) {
    check.notNegative("bladderStiffness_N_per_m", a.bladderStiffness_N_per_m);
    const bool radius = check.positive("bladderRadius_m", a.bladderRadius_m);
    const bool edge = check.positive("bladderOpeningEdge_rad", a.bladderOpeningEdge_rad);
    if (!check.range("bladderOpening_rad", a.bladderOpening_rad, 0.0, false, 0.5 * core::kPi) || !radius ||
        !edge)
        return;
    if (a.bladderOpening_rad + a.bladderOpeningEdge_rad >= core::kPi)
        check.add("bladderOpeningEdge_rad", "is " + number(a.bladderOpeningEdge_rad) +
                                                ": with the opening it covers the whole bladder");
    const double opening = a.bladderRadius_m * std::sin(a.bladderOpening_rad);
    if (opening < std::max(a.radius_m, scope.radius_m))
        check.add("bladderOpening_rad", "is " + number(a.bladderOpening_rad) + ": an opening of radius " +
                                            number(opening) +
                                            " m, narrower than the canal with the endoscope in it, " +
                                            number(std::max(a.radius_m, scope.radius_m)));
}

void checkEndoscope(Check& check, const Endoscope& scope) {
    check.positive("endoscope.radius_m", scope.radius_m);
    check.range("endoscope.beak_m", scope.beak_m, kShortestBeak_m, true);
    check.positive("endoscope.behind_m", scope.behind_m);
    if (check.positive("endoscope.fieldOfView_rad", scope.fieldOfView_rad) &&
        scope.fieldOfView_rad >= core::kPi)
        check.add("endoscope.fieldOfView_rad",
                  "is " + number(scope.fieldOfView_rad) + "; it must be below pi");
}

void checkMesh(Check& check, const UrethraMeshSettings& mesh) {
    check.range("mesh.n", mesh.n, 5, true, 129);
    check.range("mesh.w", mesh.w, 4, true, 401);
    check.range("mesh.perPatch", mesh.perPatch, 1, true, 32);
    check.range("mesh.movingSections", mesh.movingSections, 3, true, 33);
}

// Neighbouring sections meet on the concave side where the radius reaches the radius of curvature. Elsewhere
// a parabola and the straight line before it do not come near themselves.
void checkWallCrossesItself(Check& check, const UrethraAnatomy& a, const Endoscope& scope,
                            const UrethraCentreline& line) {
    const UrethraWall wall(a, scope);
    for (int i = 0; i <= kWallSamples; ++i) {
        const CentrelinePoint at = line.at(line.length_m() * i / kWallSamples);
        const double rest = wall.radius_m(at.s_m);
        const double widest = std::max(rest, scope.radius_m);
        if (widest * at.curvature_per_m < 1.0)
            continue;
        check.add(rest >= scope.radius_m ? "radius_m" : "endoscope.radius_m",
                  "the wall crosses itself at s = " + number(at.s_m) + ": there its radius is " +
                      number(widest) + " and the centre-line's radius of curvature only " +
                      number(1.0 / at.curvature_per_m));
        return;
    }
}

} // namespace

std::vector<UrethraProblem> urethraProblems(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                                            const UrethraMeshSettings& mesh) {
    Check check;
    const bool curved = check.positive("curvature_per_m", anatomy.curvature_per_m);
    const bool straight = check.range("straight_m", anatomy.straight_m, 0.0, true);
    const bool line = check.range("zEnd_m", anatomy.zEnd_m,
                                  kShortestCanal_m + (straight ? anatomy.straight_m : 0.0), true) &&
                      curved && straight;
    const UrethraCentreline centreline = line ? UrethraCentreline(anatomy) : UrethraCentreline(1.0, 1.0);
    checkWallNumbers(check, anatomy);
    if (line) {
        checkFreePart(check, anatomy, centreline.length_m());
        checkChanges(check, anatomy, centreline.length_m());
    }
    checkBladder(check, anatomy, endoscope);
    checkEndoscope(check, endoscope);
    if (check.clean())
        checkWallCrossesItself(check, anatomy, endoscope, centreline);
    checkMesh(check, mesh);
    return check.take();
}

core::Result<void> checkUrethra(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                                const UrethraMeshSettings& mesh) {
    const std::vector<UrethraProblem> problems = urethraProblems(anatomy, endoscope, mesh);
    if (problems.empty())
        return {};
    std::string message = problems.front().field + " " + problems.front().reason;
    if (problems.size() > 1)
        message += " (and " + std::to_string(problems.size() - 1) + " more)";
    return core::fail(core::ErrorCode::badInput, std::move(message));
}

} // namespace chiron::simulation
