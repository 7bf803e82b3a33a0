// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "mechanisms/fingertip_arm_chain.h"
#include "mechanisms/rotation_vector.h"

#include <Eigen/Eigenvalues>
#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Mat3;
using core::Vec3;
using mechanisms::FingertipArmDynamics;
using mechanisms::FingertipArmJoints;
using mechanisms::FingertipArmParameters;

namespace {

constexpr int kJoints = FingertipArmParameters::kJoints;
constexpr int kHandle = FingertipArmParameters::kHandle;

FingertipArmDynamics arm() {
    return FingertipArmDynamics(mechanisms::fingertipArmLinks({}));
}

FingertipArmJoints drawn(core::Random& random, double most) {
    FingertipArmJoints v;
    for (int i = 0; i < kJoints; ++i)
        v[i] = random.uniform(-most, most);
    return v;
}

/// Two thin rods that swing about x, hanging from the origin.
struct DoublePendulum {
    static constexpr double m1 = 0.7, m2 = 0.4, l1 = 0.5, l2 = 0.3;
    using Chain = mechanisms::SerialChain<2>;
    static Chain chain() {
        const auto rod = [](const Vec3& origin, double mass, double length) {
            const double across = mass * length * length / 12.0;
            return mechanisms::ChainLink{origin, Vec3::UnitX(), mass, Vec3(0.0, 0.0, -0.5 * length),
                                         Vec3(across, across, 0.0).asDiagonal()};
        };
        return Chain({rod(Vec3::Zero(), m1, l1), rod(Vec3(0.0, 0.0, -l1), m2, l2)});
    }
    // Textbook equations of a two-link arm in its plane, angles from hanging down, the second relative to the
    // first.
    static Eigen::Matrix2d inertia(const Eigen::Vector2d& q) {
        const double i1 = m1 * l1 * l1 / 12.0, i2 = m2 * l2 * l2 / 12.0, a = 0.5 * l2, c = std::cos(q[1]);
        const double both = i2 + m2 * (a * a + l1 * a * c);
        Eigen::Matrix2d m;
        m << i1 + m1 * 0.25 * l1 * l1 + i2 + m2 * (l1 * l1 + a * a + 2.0 * l1 * a * c), both, both,
            i2 + m2 * a * a;
        return m;
    }
    static Eigen::Vector2d bias(const Eigen::Vector2d& q, const Eigen::Vector2d& v) {
        const double h = m2 * l1 * 0.5 * l2 * std::sin(q[1]);
        return {-h * (2.0 * v[0] * v[1] + v[1] * v[1]), h * v[0] * v[0]};
    }
    static Eigen::Vector2d gravity(const Eigen::Vector2d& q) {
        const double g = core::kStandardGravity, second = 0.5 * m2 * l2 * g * std::sin(q[0] + q[1]);
        return {(0.5 * m1 + m2) * l1 * g * std::sin(q[0]) + second, second};
    }
};

} // namespace

class TestSerialChain : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_seed = 20261125;
        qInfo("seed %llu", static_cast<unsigned long long>(m_seed));
    }
    void doublePendulumHasItsClosedForm();
    void aPendulumSwingsWithItsPeriod();
    void jacobianIsTheDerivativeOfThePose();
    void effortsAreTheTransposedJacobian();
    void inertiaIsSymmetricPositiveDefinite();
    void inertiaIsTheKineticEnergy();
    void gravityIsTheGradientOfThePotential();
    void newtonEulerAgreesWithInertiaAndBias();
    void theBiasDoesNoWork();
    void withoutFrictionEnergyIsKept();
    void solvesItsEquations();

private:
    std::uint64_t m_seed = 0;
};

void TestSerialChain::doublePendulumHasItsClosedForm() {
    core::Random random(m_seed);
    auto chain = DoublePendulum::chain();
    for (int n = 0; n < 200; ++n) {
        const Eigen::Vector2d q(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)),
            v(random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0));
        chain.place(q);
        QVERIFY((chain.inertia() - DoublePendulum::inertia(q)).norm() < 1e-14);
        QVERIFY((chain.bias(v) - DoublePendulum::bias(q, v)).norm() < 1e-13);
        QVERIFY((chain.gravity() - DoublePendulum::gravity(q)).norm() < 1e-13);
    }
}

// A rod of length l: T = 2π √(2 l / 3 g) · (1 + A²/16 + 11 A⁴/3072), to 1e-6 at A = 0.3.
void TestSerialChain::aPendulumSwingsWithItsPeriod() {
    constexpr double length = 0.5, mass = 0.7, amplitude = 0.3;
    const double across = mass * length * length / 12.0;
    mechanisms::SerialChain<1> rod(
        {mechanisms::ChainLink{Vec3::Zero(), Vec3::UnitX(), mass, Vec3(0.0, 0.0, -0.5 * length),
                               Vec3(across, across, 0.0).asDiagonal()}});
    using Vector = mechanisms::SerialChain<1>::Vector;
    Vector q(amplitude), v(0.0);
    const double dt = 1e-5;
    double t = 0.0, crossed = 0.0;
    for (int n = 0; n < 200000 && crossed == 0.0; ++n, t += dt) {
        const double before = q[0];
        rod.place(q);
        v += 0.5 * dt * rod.solve(rod.inertia(), -rod.gravity()); // leapfrog
        q += dt * v;
        rod.place(q);
        v += 0.5 * dt * rod.solve(rod.inertia(), -rod.gravity());
        if (q[0] <= 0.0)
            crossed = t + dt * before / (before - q[0]); // a quarter of the period
    }
    const double a2 = amplitude * amplitude;
    const double period = 2.0 * core::kPi * std::sqrt(2.0 * length / (3.0 * core::kStandardGravity)) *
                          (1.0 + a2 / 16.0 + 11.0 * a2 * a2 / 3072.0);
    QVERIFY2(std::abs(4.0 * crossed / period - 1.0) < 5e-6,
             qPrintable(QString("%1 %2").arg(4.0 * crossed).arg(period, 0, 'g', 9)));
}

void TestSerialChain::jacobianIsTheDerivativeOfThePose() {
    core::Random random(m_seed + 1);
    auto chain = arm();
    constexpr double h = 1e-6;
    for (int n = 0; n < 50; ++n) {
        const FingertipArmJoints q = drawn(random, 1.5), rates = drawn(random, 2.0);
        const Vec3 offset(0.01, -0.02, 0.03);
        const auto poseAt = [&](const FingertipArmJoints& at) {
            chain.place(at);
            return std::pair(chain.point(kHandle, offset), core::Quat(chain.orientation(kHandle)));
        };
        chain.place(q);
        const FingertipArmDynamics::Jacobian j = chain.jacobian(kHandle, chain.point(kHandle, offset));
        Vec3 v, w;
        chain.velocity(kHandle, chain.point(kHandle, offset), rates, v, w);
        QVERIFY((j.topRows<3>() * rates - v).norm() < 1e-13 &&
                (j.bottomRows<3>() * rates - w).norm() < 1e-13);
        for (int i = 0; i < kJoints; ++i) {
            FingertipArmJoints step = FingertipArmJoints::Zero();
            step[i] = h;
            const auto [before, turnBefore] = poseAt(q - step);
            const auto [after, turnAfter] = poseAt(q + step);
            QVERIFY((j.block<3, 1>(0, i) - (after - before) / (2.0 * h)).norm() < 1e-9);
            QVERIFY((j.block<3, 1>(3, i) -
                     mechanisms::rotationVectorOf(turnAfter * turnBefore.conjugate()) / (2.0 * h))
                        .norm() < 1e-8);
        }
        QVERIFY(j.col(FingertipArmParameters::kJaw).norm() == 0.0); // the lever does not move the handle
    }
}

void TestSerialChain::effortsAreTheTransposedJacobian() {
    core::Random random(m_seed + 2);
    auto chain = arm();
    for (int n = 0; n < 50; ++n) {
        chain.place(drawn(random, 1.5));
        core::Wrench f;
        f.force = Vec3(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0));
        f.torque = Vec3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1));
        const Vec3 at = chain.joint(FingertipArmParameters::kWrist);
        Eigen::Matrix<double, 6, 1> wrench;
        wrench << f.force, f.torque;
        QVERIFY((chain.efforts(kHandle, at, f) - chain.jacobian(kHandle, at).transpose() * wrench).norm() <
                1e-14);
    }
}

void TestSerialChain::inertiaIsSymmetricPositiveDefinite() {
    core::Random random(m_seed + 3);
    auto chain = arm();
    double least = 1e9;
    for (int n = 0; n < 300; ++n) {
        chain.place(drawn(random, 3.0));
        const FingertipArmDynamics::Matrix m = chain.inertia();
        QVERIFY((m - m.transpose()).norm() == 0.0);
        least =
            std::min(least, Eigen::SelfAdjointEigenSolver<FingertipArmDynamics::Matrix>(m).eigenvalues()[0]);
    }
    QVERIFY2(least > 1e-6, qPrintable(QString::number(least))); // the lever's own, 12 mg·m²
}

// ½ q̇ᵀ M q̇ is that of the bodies, each by its own velocities.
void TestSerialChain::inertiaIsTheKineticEnergy() {
    core::Random random(m_seed + 4);
    const auto links = mechanisms::fingertipArmLinks({});
    FingertipArmDynamics chain(links);
    for (int n = 0; n < 50; ++n) {
        const FingertipArmJoints rates = drawn(random, 4.0);
        chain.place(drawn(random, 2.0));
        double kinetic = 0.0;
        for (int i = 0; i < kJoints; ++i) {
            const auto& link = links[static_cast<std::size_t>(i)];
            Vec3 v, w;
            chain.velocity(i, chain.point(i, link.centreOfMass_m), rates, v, w);
            const Vec3 own = chain.orientation(i).transpose() * w;
            kinetic += 0.5 * (link.mass_kg * v.squaredNorm() + own.dot(link.inertia_kgm2 * own));
        }
        const double byInertia = 0.5 * rates.dot(chain.inertia() * rates);
        QVERIFY2(std::abs(byInertia - kinetic) < 1e-12 * (1.0 + kinetic),
                 qPrintable(QString("%1 %2").arg(byInertia).arg(kinetic)));
    }
}

void TestSerialChain::gravityIsTheGradientOfThePotential() {
    core::Random random(m_seed + 5);
    auto chain = arm();
    constexpr double h = 1e-6;
    for (int n = 0; n < 50; ++n) {
        const FingertipArmJoints q = drawn(random, 2.0);
        chain.place(q);
        const FingertipArmJoints g = chain.gravity();
        for (int i = 0; i < kJoints; ++i) {
            FingertipArmJoints step = FingertipArmJoints::Zero();
            step[i] = h;
            chain.place(q + step);
            const double up = chain.potential_J();
            chain.place(q - step);
            QVERIFY2(std::abs(g[i] - (up - chain.potential_J()) / (2.0 * h)) < 1e-8,
                     qPrintable(QString::number(i)));
        }
    }
}

void TestSerialChain::newtonEulerAgreesWithInertiaAndBias() {
    core::Random random(m_seed + 6);
    auto chain = arm();
    for (int n = 0; n < 100; ++n) {
        const FingertipArmJoints rates = drawn(random, 4.0), accelerations = drawn(random, 50.0);
        chain.place(drawn(random, 2.0));
        const FingertipArmJoints whole = chain.inverseDynamics(rates, accelerations, core::kStandardGravity);
        const FingertipArmJoints parts =
            chain.inertia() * accelerations + chain.bias(rates) + chain.gravity();
        QVERIFY2((whole - parts).norm() < 1e-12 * (1.0 + whole.norm()),
                 qPrintable(QString::number((whole - parts).norm())));
    }
}

// q̇ᵀ (½ Ṁ q̇ − c) = 0: Ṁ − 2C is skew, so the bias neither makes nor takes energy.
void TestSerialChain::theBiasDoesNoWork() {
    core::Random random(m_seed + 7);
    auto chain = arm();
    constexpr double h = 1e-6;
    for (int n = 0; n < 50; ++n) {
        const FingertipArmJoints q = drawn(random, 2.0), rates = drawn(random, 3.0);
        chain.place(q + h * rates);
        const FingertipArmDynamics::Matrix after = chain.inertia();
        chain.place(q - h * rates);
        const FingertipArmDynamics::Matrix before = chain.inertia();
        chain.place(q);
        const double rest =
            0.5 * rates.dot((after - before) * rates) / (2.0 * h) - rates.dot(chain.bias(rates));
        QVERIFY2(std::abs(rest) < 1e-7, qPrintable(QString::number(rest)));
    }
}

// The whole arm falls freely for half a second (Runge–Kutta, 0.1 ms): what is lost of 1 J is the
// integrator's.
void TestSerialChain::withoutFrictionEnergyIsKept() {
    auto chain = arm();
    FingertipArmJoints q, v;
    q << 0.3, -0.6, 1.4, -0.5, 0.2, -0.4, 0.3;
    v << 1.0, -0.5, 0.8, 2.0, -1.5, 1.0, -0.5;
    const auto acceleration = [&](const FingertipArmJoints& at, const FingertipArmJoints& rates) {
        chain.place(at);
        return FingertipArmJoints(FingertipArmDynamics::solve(
            chain.inertia(),
            -chain.inverseDynamics(rates, FingertipArmJoints::Zero(), core::kStandardGravity)));
    };
    const auto energy = [&] {
        chain.place(q);
        return 0.5 * v.dot(chain.inertia() * v) + chain.potential_J();
    };
    const double start = energy();
    double moved = 0.0;
    constexpr double dt = 1e-4;
    for (int n = 0; n < 5000; ++n) {
        const FingertipArmJoints a1 = acceleration(q, v), v2 = v + 0.5 * dt * a1;
        const FingertipArmJoints a2 = acceleration(q + 0.5 * dt * v, v2), v3 = v + 0.5 * dt * a2;
        const FingertipArmJoints a3 = acceleration(q + 0.5 * dt * v2, v3), v4 = v + dt * a3;
        const FingertipArmJoints a4 = acceleration(q + dt * v3, v4);
        q += dt / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
        v += dt / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
        moved = std::max(moved, 0.5 * v.dot(chain.inertia() * v));
    }
    QVERIFY2(moved > 0.3, qPrintable(QString::number(moved)));
    QVERIFY2(std::abs(energy() - start) < 1e-7, qPrintable(QString::number(energy() - start)));
}

void TestSerialChain::solvesItsEquations() {
    core::Random random(m_seed + 8);
    auto chain = arm();
    for (int n = 0; n < 50; ++n) {
        chain.place(drawn(random, 2.0));
        const FingertipArmJoints b = drawn(random, 1.0);
        const FingertipArmJoints x = FingertipArmDynamics::solve(chain.inertia(), b);
        QVERIFY((chain.inertia() * x - b).norm() < 1e-10 * (1.0 + x.norm()));
    }
}

QTEST_APPLESS_MAIN(TestSerialChain)
#include "test_serial_chain.moc"
