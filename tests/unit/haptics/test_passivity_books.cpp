// SPDX-License-Identifier: GPL-3.0-or-later
// The books of bodies alone (passivity_controller.h), without devices: who owes what, what is softened and
// what comes back.
#include "haptics/passivity_controller.h"

#include "simulation/attributes/elasticity.h"
#include "support/passive_object.h"
#include "unit/haptics/safety_rig.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;

namespace {

/// A controller with two tools, armed, without caps in the way.
struct Books {
    Books() {
        controller.reset({});
        for (auto& limit : limits)
            limit.renders = true;
        states.count = 2;
    }
    /// Tool i of body `of[i]` is shown f[i]; then moves by dx[i].
    void tick(const std::array<std::uint8_t, 2>& of, const std::array<double, 2>& force,
              const std::array<double, 2>& dx, const std::array<double, 4>& energy, double stiffness = 0.0) {
        haptics::PassivityBodies bodies;
        for (std::size_t i = 0; i < 2; ++i) {
            bodies.bodyOf[i] = of[i];
            haptics::PassivityContact& c = bodies.contacts[of[i]];
            c.members[i] = true;
            c.share[i] = of[0] == of[1] ? 0.5 : 1.0;
            c.capRatio[i] = 1.0;
        }
        for (std::size_t body = 0; body < 4; ++body) {
            haptics::PassivityContact& c = bodies.contacts[body];
            c.givesWay = true;
            c.gain = c.gainBefore = 1.0;
            c.stored_J = energy[body];
            c.stiffness_N_per_m = stiffness;
            c.touching = energy[body] > 0.0 || stiffness > 0.0;
        }
        haptics::PassivityController::Wrenches wrenches{};
        for (std::size_t i = 0; i < 2; ++i)
            wrenches[i].force.x() = force[i];
        acted = controller.apply(limits, 2, states, bodies, wrenches);
        core::ToolWrenches shown;
        shown.count = 2;
        for (std::size_t i = 0; i < 2; ++i)
            shown.tools[i] = wrenches[i];
        controller.hold(states, shown);
        share = force[0] != 0.0 ? wrenches[0].force.x() / force[0] : 1.0;
        for (std::size_t i = 0; i < 2; ++i)
            states.tools[i].p_WT.x() += dx[i];
    }
    haptics::PassivityController controller;
    haptics::PassivityController::Limits limits{};
    core::ToolStates states;
    bool acted = false;
    double share = 1.0;
};

} // namespace

class TestPassivityBooks : public QObject {
    Q_OBJECT
private slots:
    void oneBodyCannotBorrowFromAnother();
    void aHeldBodyKeepsItsBookWhileItIsSlack();
    void booksGoWithTheirTools();
    void whoeverStaysKeepsTheBook_data();
    void whoeverStaysKeepsTheBook();
    void whereNothingIsLoadedNothingIsSoftened();
    void aSoftenedBodyRecoversOnWorkAlone();
    void bookOfABodyIsThatOfP2();
    void onlyTheBookOfWhatWasShownIsRight();
    void capsAreBookedAtTheShare();
    void aStiffeningSpringIsBookedAtNoMoreThanItHolds();
    void aStiffeningSpringAtItsCapIsLeftAlone();
};

void TestPassivityBooks::oneBodyCannotBorrowFromAnother() {
    // Tool 1 pushes into its spring: 1 N over 20 mm, 20 mJ in. Tool 0 is pushed by 1 N over 20 mm, and nobody
    // pays.
    for (const bool apart : {false, true}) {
        Books books;
        double least = 1.0;
        for (int n = 0; n < 200; ++n) {
            const double in = 1e-4 * n;
            books.tick({0, static_cast<std::uint8_t>(apart ? 1 : 0)}, {1.0, 1.0}, {1e-4, -1e-4},
                       apart ? std::array{5e-4, in, 0.0, 0.0} : std::array{5e-4, 0.0, 0.0, 0.0});
            least = std::min(least, books.share);
        }
        QCOMPARE(least < 0.5, apart); // together the one pays for the other
    }
}

void TestPassivityBooks::aHeldBodyKeepsItsBookWhileItIsSlack() {
    // Each pull gives back 0.8 mJ more than it took, and the tube is slack in between.
    for (const bool held : {false, true}) {
        Books books;
        bool acted = false;
        for (int pull = 0; pull < 5; ++pull) {
            for (int n = 0; n < 8; ++n) {
                books.tick({0, 0}, {1.0, 0.0}, {1e-4, 0.0}, {1e-4, 0.0, 0.0, 0.0}, held ? 500.0 : 0.0);
                acted = acted || books.acted;
            }
            books.tick({0, 0}, {0.0, 0.0}, {0.0, 0.0}, {}, held ? 500.0 : 0.0);
        }
        QCOMPARE(acted, held);
    }
}

void TestPassivityBooks::booksGoWithTheirTools() {
    Books books;
    // Both at bodies of their own, 2 mJ put into each by 1 N over 2 mm.
    for (int n = 0; n <= 20; ++n)
        books.tick({0, 1}, {1.0, 1.0}, {n < 20 ? -1e-4 : 0.0, n < 20 ? -1e-4 : 0.0},
                   {1e-4 * n, 1e-4 * n, 0.0, 0.0});
    QVERIFY(std::abs(books.controller.supplied_J() - 4e-3) < 1e-6);
    // They become one: the books are one, nothing is lost and nothing is owed.
    books.tick({0, 0}, {1.0, 1.0}, {0.0, 0.0}, {4e-3, 0.0, 0.0, 0.0});
    QVERIFY(std::abs(books.controller.excess_J(0)) < 1e-6 && !books.acted);
    // One of two again, with a quarter of it: what it holds goes along.
    books.tick({0, 2}, {1.0, 1.0}, {0.0, 0.0}, {3e-3, 0.0, 1e-3, 0.0});
    QVERIFY(std::abs(books.controller.excess_J(2)) < 1e-6 && std::abs(books.controller.excess_J(0)) < 1e-6);
}

void TestPassivityBooks::whoeverStaysKeepsTheBook_data() {
    QTest::addColumn<bool>("firstStays");
    QTest::newRow("the first tool stays") << true;
    QTest::newRow("the second tool stays") << false;
}

/// Of two tools at one body one leaves it with a quarter of what it holds; the rest is of the one that stays.
void TestPassivityBooks::whoeverStaysKeepsTheBook() {
    QFETCH(bool, firstStays);
    Books books;
    for (int n = 0; n <= 20; ++n) // 4 mJ in, by 1 N of each tool over 2 mm
        books.tick({0, 0}, {1.0, 1.0}, {n < 20 ? -1e-4 : 0.0, n < 20 ? -1e-4 : 0.0},
                   {2e-4 * n, 0.0, 0.0, 0.0});
    const std::array<std::uint8_t, 2> of =
        firstStays ? std::array<std::uint8_t, 2>{0, 1} : std::array<std::uint8_t, 2>{1, 0};
    books.tick(of, {1.0, 1.0}, {0.0, 0.0}, {3e-3, 1e-3, 0.0, 0.0});
    QVERIFY2(std::abs(books.controller.excess_J(0)) < 1e-6,
             qPrintable(QString::number(books.controller.excess_J(0))));
    QVERIFY2(std::abs(books.controller.excess_J(1)) < 1e-6,
             qPrintable(QString::number(books.controller.excess_J(1))));
}

void TestPassivityBooks::whereNothingIsLoadedNothingIsSoftened() {
    Books books; // 1 N carried down 0.2 m: 200 mJ come out of what holds nothing elastic
    for (int n = 0; n < 2000; ++n) {
        books.tick({0, 1}, {-1.0, 0.0}, {-1e-4, 0.0}, {1e-6, 0.0, 0.0, 0.0}, 300.0);
        QCOMPARE(books.share, 1.0);
    }
    QVERIFY(std::abs(books.controller.work_J() + 0.2) < 2e-4); // the plain work, nothing forgiven
    QVERIFY(books.controller.supplied_J() - books.controller.work_J() < 1.001e-3);
}

void TestPassivityBooks::aSoftenedBodyRecoversOnWorkAlone() {
    Books books;
    for (int n = 0; n < 20; ++n) // 2 mJ put in
        books.tick({0, 1}, {1.0, 0.0}, {-1e-4, 0.0}, {1e-4 * n, 0.0, 0.0, 0.0}, 300.0);
    for (int n = 0; n < 25; ++n) // 2.5 mJ given away, and 2 mJ still held
        books.tick({0, 1}, {1.0, 0.0}, {1e-4, 0.0}, {2e-3, 0.0, 0.0, 0.0}, 300.0);
    for (int n = 0; n < 10'000; ++n) // falls until the book is paid
        books.tick({0, 1}, {1.0, 0.0}, {0.0, 0.0}, {2e-3, 0.0, 0.0, 0.0}, 300.0);
    const double fallen = books.share;
    QVERIFY(fallen < 0.95 && fallen > 2.0 * haptics::PassivityController::kLeastShare);
    for (int n = 0; n < 10'000; ++n) // time alone brings nothing back
        books.tick({0, 1}, {1.0, 0.0}, {0.0, 0.0}, {2e-3, 0.0, 0.0, 0.0}, 300.0);
    QVERIFY(books.share <= fallen);
    double most = 0.0;
    for (int n = 0; n < 30'000; ++n) { // 1 N against the hand for 30 mm
        const double before = books.share;
        books.tick({0, 1}, {1.0, 0.0}, {-1e-6, 0.0}, {2e-3, 0.0, 0.0, 0.0}, 300.0);
        most = std::max(most, books.share - before);
    }
    QCOMPARE(books.share, 1.0);
    QVERIFY(most > 0.0 && most <= haptics::PassivityController::kRise * 1.001);
    books.tick({0, 1}, {0.0, 0.0}, {0.0, 0.0}, {}); // let go of: a new book
    QCOMPARE(books.controller.work_J(), 0.0);
}

namespace {

/// P2's passive object and the supervisor's book of one body, with the same motion and the same force of two
/// tools.
struct SideBySide {
    void tick(const std::array<core::Vec3, 2>& p, const std::array<core::Vec3, 2>& asked,
              const std::array<core::Vec3, 2>& shown, const std::array<bool, 2>& touching, double stored_J) {
        core::ToolStates states;
        core::ToolWrenches held;
        states.count = held.count = 2;
        std::array<bool, core::kMaxTools> members{};
        for (std::size_t i = 0; i < 2; ++i) {
            states.tools[i].p_WT = p[i];
            held.tools[i].force = shown[i];
            members[i] = touching[i];
            published.update(i, touching[i], p[i], asked[i], 0.5 * stored_J);
        }
        book.addWork(states);
        book.hold(states, held, members);
    }
    tests::PassiveObject published;
    haptics::PassivityObserver book;
};

} // namespace

// The object is passive or not by both, to rounding: for a spring, for a stiffness that is told too late, and
// through two tools.
void TestPassivityBooks::bookOfABodyIsThatOfP2() {
    const core::Vec3 z = core::Vec3::UnitZ(), x = core::Vec3::UnitX(), none = core::Vec3::Zero();
    for (const double kOut : {500.0, 1200.0}) {
        SideBySide both;
        for (int n = 0; n < 2000; ++n) {
            const double d = 0.003 * (n <= 1000 ? n : 2000 - n) / 1000.0, k = n <= 1000 ? 500.0 : kOut;
            const core::Vec3 f = k * d * z;
            both.tick({-d * z, none}, {f, none}, {f, none}, {true, false}, k * d * d);
            QVERIFY(std::abs(both.published.displayed_J() + both.book.supplied_J()) < 1e-12);
        }
        QCOMPARE(both.book.supplied_J() < -1e-3, kOut > 500.0); // 3.2 mJ came from nowhere
    }
    SideBySide both; // a spring between two tools: stretched by the first, let in by the second
    for (int n = 0; n < 2000; ++n) {
        const double a = 0.01 * std::min(n, 1000) / 1000.0, b = 0.01 * std::max(0, n - 1000) / 1000.0;
        const core::Vec3 f = -100.0 * (a - b) * x;
        both.tick({a * x, b * x}, {f, -f}, {f, -f}, {true, true}, 50.0 * (a - b) * (a - b));
        QVERIFY(std::abs(both.published.displayed_J() + both.book.supplied_J()) < 1e-12);
    }
    QVERIFY(std::abs(both.book.supplied_J()) <
            2e-5); // neither alone: the first gave 5 mJ, the second got them
}

// Why the scene keeps no such object: it knows the force it asked for. Capped to 1 N on the way in and felt
// whole on the way out, the spring gives more than it took, and a book of what was asked for says that
// nothing happened.
void TestPassivityBooks::onlyTheBookOfWhatWasShownIsRight() {
    const core::Vec3 z = core::Vec3::UnitZ(), none = core::Vec3::Zero();
    SideBySide both;
    double work_J = 0.0, before = 0.0, force = 0.0;
    for (int n = 0; n < 2000; ++n) {
        const double d = 0.004 * (n <= 1000 ? n : 2000 - n) / 1000.0;
        work_J += force * (d - before); // of the hand on the spring, as shown
        before = d;
        force = n <= 1000 ? std::min(1.0, 500.0 * d) : 500.0 * d;
        both.tick({-d * z, none}, {500.0 * d * z, none}, {force * z, none}, {true, false}, 500.0 * d * d);
    }
    QVERIFY2(work_J < -0.9e-3, qPrintable(QString::number(work_J)));
    QVERIFY(std::abs(both.book.supplied_J() - work_J) < 1e-9);
    QVERIFY(std::abs(both.published.displayed_J()) < 1e-5);
}

void TestPassivityBooks::capsAreBookedAtTheShare() {
    haptics::PassivityContact contact;
    contact.members[0] = true;
    contact.share[0] = 1.0;
    contact.stored_J = 0.01;
    contact.capRatio[0] = 0.5; // twice the cap is asked for
    const auto held = [&](double scale) {
        return haptics::PassivityController::renderedEnergy_J(contact, scale, 1);
    };
    // ∫ min(c f, f/2) over the stretch x of f = k x: c U s(2 - s), s = 1/(2c)
    for (const double c : {0.1, 0.3, 0.5, 0.8, 1.0}) {
        double sum = 0.0;
        constexpr int kSteps = 20'000;
        for (int i = 0; i < kSteps; ++i)
            sum += 2.0 * contact.stored_J * std::min(c * (i + 0.5) / kSteps, 0.5) / kSteps;
        QVERIFY(std::abs(held(c) - sum) < 1e-9);
    }
}

namespace {

constexpr double kCap_N = 4.0;
constexpr double kTears_N = 8.0; ///< twice the cap, where a tube tears

/// The stretch at which a law pulls with `tension_N`.
double stretchOf_m(const simulation::ElasticLaw& law, double tension_N) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (law.tension(middle) < tension_N ? low : high) = middle;
    }
    return low;
}

} // namespace

/// Against ∫ min(T, cap): the same for a linear tube, and less for one that stiffens, but for 12 %.
void TestPassivityBooks::aStiffeningSpringIsBookedAtNoMoreThanItHolds() {
    for (const double stiffening_per_m : {0.0, 20.0, 60.0, 200.0, 1000.0}) {
        const simulation::ElasticLaw law{60.0, stiffening_per_m};
        const double atCap_m = stretchOf_m(law, kCap_N), torn_m = stretchOf_m(law, kTears_N);
        for (int i = 1; i <= 100; ++i) {
            const double x = torn_m * i / 100.0;
            haptics::PassivityContact contact;
            contact.members[0] = true;
            contact.share[0] = 1.0;
            contact.stored_J = law.energy(x);
            contact.capRatio[0] = kCap_N / law.tension(x);
            const double booked_J = haptics::PassivityController::renderedEnergy_J(contact, 1.0, 1);
            const double held_J = law.energy(std::min(x, atCap_m)) + kCap_N * std::max(0.0, x - atCap_m);
            QVERIFY(booked_J <= held_J * (1.0 + 1e-9));
            QVERIFY(booked_J >= (stiffening_per_m > 0.0 ? 0.88 : 1.0 - 1e-9) * held_J);
        }
    }
}

/// Slowly out to where it tears and back again: nothing is rendered softer, and nobody gets more than was put
/// in.
void TestPassivityBooks::aStiffeningSpringAtItsCapIsLeftAlone() {
    const simulation::ElasticLaw law{60.0, 60.0};
    const double torn_m = stretchOf_m(law, kTears_N);
    devices::DeviceDescriptor device = test::sixAxisDevice();
    device.inProcess = true;
    device.oldestSample_us = 0;
    test::SafetyRig rig(device);
    rig.arm();
    double most_N = 0.0;
    for (int tick = 1; tick < 4000; ++tick) {
        const double x = torn_m * (1.0 - std::abs(tick - 2000) / 2000.0);
        rig.states.tools[0].p_WT = core::Vec3(x, 0, 0);
        rig.ask(core::Vec3(-law.tension(x), 0, 0));
        rig.scene.energyByBody = true;
        rig.scene.bodyEnergy_J[0] = law.energy(x);
        rig.scene.bodyStiffness_N_per_m[0] = law.slope(x);
        rig.tick();
        most_N = std::max(most_N, rig.force().norm());
        QVERIFY((rig.out.guards & core::guard_bits::kPassivity) == 0);
        QVERIFY(rig.out.energySupplied_J > -1e-3);
    }
    QVERIFY(std::abs(most_N - kCap_N) < 1e-9);
    QVERIFY(std::abs(rig.out.energySupplied_J) < 1e-3);
}

QTEST_APPLESS_MAIN(TestPassivityBooks)
#include "test_passivity_books.moc"
