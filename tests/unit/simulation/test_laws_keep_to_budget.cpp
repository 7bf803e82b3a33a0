// SPDX-License-Identifier: GPL-3.0-or-later
// No law damps a tool by more than its budget, whatever its content asks for: ‖f(v) − f(0)‖ ≤ b ‖v‖, and what
// it says it used is at most b and at least what it damps. With a budget that is large enough nothing
// changes, to the bit.
#include "core/random.h"
#include "core/units.h"
#include "modules/exercises/elastic_tube/simulation/tube_chain.h"
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "simulation/comparison/compared_object.h"
#include "simulation/objects/object_contact.h"
#include "tissue_laws.h"
#include "urethra_states.h"

#include <QtTest>
#include <array>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::Vec3;

namespace {

constexpr double kBudget = 12.0; ///< N·s/m
constexpr double kRounding = 1e-12;

/// `feel(v, budget)` → {force, damping used}, of one place.
struct Felt {
    Vec3 force;
    double used;
};

template <class Feel> bool keeps(const Feel& feel, const Vec3& v) {
    const Felt still = feel(Vec3::Zero(), kBudget), moving = feel(v, kBudget);
    const Felt free = feel(v, std::numeric_limits<double>::infinity()), ample = feel(v, 1e6);
    const double damped = (moving.force - still.force).norm();
    return damped <= kBudget * v.norm() * (1.0 + 1e-9) + kRounding &&
           damped <= moving.used * v.norm() * (1.0 + 1e-9) + kRounding &&
           moving.used <= kBudget * (1.0 + 1e-9) && moving.used >= 0.0 && free.force == ample.force &&
           free.used == ample.used;
}

} // namespace

class TestLawsKeepToBudget : public QObject {
    Q_OBJECT
private slots:
    void aBudgetIsSpentOnce();
    void objects();
    void spheres();
    void tissue();
    void tubes();
    void comparedObjects();
    void urethra();
};

void TestLawsKeepToBudget::aBudgetIsSpentOnce() {
    DampingBudget budget(30.0);
    budget.spend(12.0);
    QCOMPARE(budget.left_Ns_per_m(), 18.0);
    budget.spend(20.0);
    QCOMPARE(budget.left_Ns_per_m(), 0.0);
    QCOMPARE(budget.used_Ns_per_m(), 32.0);
    QCOMPARE(DampingBudget::share(10.0, 30.0), 1.0);
    QCOMPARE(DampingBudget::share(40.0, 30.0), 0.75);
    QCOMPARE(DampingBudget::share(40.0, -1.0), 0.0);
    QCOMPARE(DampingBudget(-1.0).left_Ns_per_m(), 0.0);
}

void TestLawsKeepToBudget::objects() {
    core::Random random(1);
    for (int n = 0; n < 2000; ++n) {
        ObjectAttributes attributes;
        attributes.damping_Ns_per_m = random.uniform(0.0, 50.0);
        attributes.viscosity_Ns_per_m = random.uniform(0.0, 50.0);
        const ObjectContact contact(attributes);
        const double depth = random.uniform(0.0, 0.004);
        QVERIFY(keeps(
            [&](const Vec3& v, double most) {
                ContactPlace place;
                place.depth_m = depth;
                place.velocity = v;
                place.mostDamping_Ns_per_m = most;
                ObjectContactState state;
                const auto felt = contact.respond(place, core::kTickSeconds, state);
                return Felt{felt.force, felt.damping_Ns_per_m};
            },
            randomVector(random, 0.1)));
    }
}

void TestLawsKeepToBudget::spheres() {
    core::Random random(2);
    for (int n = 0; n < 2000; ++n) {
        HemisphereContact::Parameters parameters;
        parameters.damping_Ns_per_m = random.uniform(0.0, 50.0);
        const HemisphereContact contact(parameters);
        const Vec3 p(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), random.uniform(-0.003, 0.021));
        QVERIFY(keeps(
            [&](const Vec3& v, double most) {
                const auto felt = contact.respond(p, v, most);
                return Felt{felt.force, felt.damping_Ns_per_m};
            },
            randomVector(random, 0.1)));
    }
}

void TestLawsKeepToBudget::tissue() {
    core::Random random(3);
    for (int n = 0; n < 2000; ++n) {
        TissueParameters parameters;
        parameters.damping_Ns_per_m =
            Vec3(random.uniform(0.0, 50.0), random.uniform(0.0, 50.0), random.uniform(0.0, 50.0));
        const TissueContact contact(parameters);
        const Vec3 p(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), random.uniform(-0.004, 0.0));
        QVERIFY(keeps(
            [&](const Vec3& v, double most) {
                TissueTouch touch;
                const auto felt = contact.respond(toolAt(p, v), touch, most);
                return Felt{felt.force, felt.damping_Ns_per_m};
            },
            randomVector(random, 0.05)));
    }
}

/// Both ends held, or one and the middle: each hand as the other moves against it.
void TestLawsKeepToBudget::tubes() {
    core::Random random(4);
    for (int n = 0; n < 1000; ++n) {
        TubeShape shape;
        shape.law.elastic = {200.0, 0.0};
        shape.law.viscosity_Ns_per_m = random.uniform(0.0, 40.0);
        shape.fixed = n % 2 == 0;
        shape.nodes = 3;
        shape.share = {0.0, random.uniform(0.3, 0.7), 1.0};
        const double stretch = random.uniform(1.1, 1.5);
        const Vec3 way = (shape.fixed ? Vec3::UnitZ() : Vec3::UnitX()) * shape.length_m * stretch;
        const auto feel = [&](const Vec3& v, double most) {
            TubeChain tube(shape);
            TubeChain::Holds holds{};
            const std::array<Vec3, 3> moves{v, -v, v}; // against its neighbours
            for (std::size_t i = shape.fixed ? 1 : 0; i < 3; ++i)
                holds[i] = {true, shape.share[i] * way, moves[i], most};
            (void)tube.step(holds);
            const TubeAnswer answer = tube.step(holds);
            return Felt{answer.force[1], answer.damping_Ns_per_m[1]}; // the middle one feels two pieces
        };
        QVERIFY(keeps(feel, randomVector(random, 0.02)));
    }
}

void TestLawsKeepToBudget::comparedObjects() {
    core::Random random(5);
    for (const ComparedAttribute attribute :
         {ComparedAttribute::stiffness, ComparedAttribute::mass, ComparedAttribute::viscosity})
        for (int n = 0; n < 500; ++n) {
            ComparisonParameters parameters;
            parameters.attribute = attribute;
            parameters.object.damping_Ns_per_m = random.uniform(0.0, 50.0);
            parameters.object.viscosity_Ns_per_m = random.uniform(0.0, 50.0);
            const double value = attribute == ComparedAttribute::mass        ? 0.02
                                 : attribute == ComparedAttribute::stiffness ? 200.0
                                                                             : random.uniform(0.0, 50.0);
            const double deep = random.uniform(0.0, 0.003);
            const Vec3 foot(placeX_m(parameters, 0), 0.0, 0.0),
                ring = foot + parameters.hookHeight_m * Vec3::UnitZ();
            QVERIFY(keeps(
                [&](const Vec3& v, double most) {
                    ComparedObject object;
                    object.set(parameters, 0, value, 1);
                    if (attribute != ComparedAttribute::viscosity)
                        (void)object.respond(ring, Vec3::Zero(), most); // taken hold of
                    const Vec3 p = attribute == ComparedAttribute::stiffness
                                       ? Vec3(ring + deep * Vec3::UnitZ())
                                   : attribute == ComparedAttribute::mass ? Vec3(ring - deep * Vec3::UnitZ())
                                                                          : Vec3(foot - deep * Vec3::UnitZ());
                    const auto felt = object.respond(p, v, most);
                    return Felt{felt.force, felt.damping_Ns_per_m};
                },
                randomVector(random, 0.05)));
        }
}

void TestLawsKeepToBudget::urethra() {
    core::Random random(6);
    for (const double viscosity : {36.0, 400.0}) { // the level's, and one that would use all of it
        UrethraAnatomy anatomy = strictured();
        anatomy.viscosity_Ns_per_m2 = viscosity;
        anatomy.wallRetardation_s = viscosity > 36.0 ? 0.1 : 0.005; // likewise
        const UrethraForces forces(anatomy, {});
        double most = 0.0;
        for (int n = 0; n < 20000; ++n) {
            EndoscopeMotion motion = randomMotion(random, forces.centreline());
            motion.w_A.setZero();
            const Vec3 v = 0.2 * motion.v_A;
            QVERIFY(keeps(
                [&](const Vec3& speed, double budget) {
                    EndoscopeMotion moved = motion;
                    moved.v_A = speed;
                    moved.mostDamping_Ns_per_m = budget;
                    const auto felt = forces.respond(moved);
                    return Felt{felt.wrench_A.force, felt.damping_Ns_per_m};
                },
                v));
            motion.v_A.setZero();
            motion.mostDamping_Ns_per_m = kBudget;
            const UrethraResponse still = forces.respond(motion);
            most = std::max(most, still.damping_Ns_per_m);
            QVERIFY(still.wrench_A.force.allFinite());
            motion.mostDamping_Ns_per_m = 0.0;
            motion.v_A = v;
            const UrethraResponse none = forces.respond(motion);
            QVERIFY(none.friction_N == 0.0 && none.viscous_N == 0.0 && none.torqueZ_Nm == 0.0);
        }
        QVERIFY(most > 0.99 * kBudget); // it is used
    }
}

QTEST_APPLESS_MAIN(TestLawsKeepToBudget)
#include "test_laws_keep_to_budget.moc"
