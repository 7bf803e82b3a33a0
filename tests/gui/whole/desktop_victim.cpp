// SPDX-License-Identifier: GPL-3.0-or-later
// The program in the middle of a set, to be killed: prints the database's path once so many ticks are
// recorded, then goes on.
#include "desktop/training/training_screen.h"
#include "support/desktop_fixture.h"

#include <cstdio>

using namespace chiron;

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    if (application.arguments().size() != 2)
        return 2;
    const std::uint64_t ticks = application.arguments().at(1).toULongLong();
    tests::DesktopFixture desktop;
    desktop.logIn("tina");
    desktop.go(QStringLiteral("training"), {{QStringLiteral("exercise"), QStringLiteral("sphere_apex")},
                                            {QStringLiteral("level"), 1},
                                            {QStringLiteral("device"), QStringLiteral("mouse")}});
    tests::pressGo(desktop);
    const auto recorded = [&] {
        auto* screen = desktop.screen<desktop::TrainingScreen>();
        return screen && screen->feed() &&
               screen->feed()->state().tick >= ticks; // each executed tick has its own number and is recorded
    };
    if (!QTest::qWaitFor(recorded, 60000))
        return 1;
    std::printf("%s\n", qPrintable(desktop.file()));
    std::fflush(stdout);
    return QApplication::exec(); // until it is killed
}
