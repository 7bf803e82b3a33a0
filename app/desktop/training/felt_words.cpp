// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/felt_words.h"

#include <QCoreApplication>

namespace chiron::desktop::felt_words {

namespace {
struct Words {
    Q_DECLARE_TR_FUNCTIONS(FeltWords)
};
} // namespace

QString device(const QString& name, bool felt) {
    return felt ? Words::tr("%1: force felt").arg(name) : Words::tr("%1: force shown, not felt").arg(name);
}

QString noMeasurements(bool felt) {
    return felt ? Words::tr("This level shows no measurements: rely on what you feel. Everything is recorded "
                            "and appears in the results.")
                : Words::tr("This level shows no measurements: rely on the scene. Everything is recorded and "
                            "appears in the results.");
}

QString objects(bool felt) {
    return felt ? Words::tr("You feel the objects through the device.")
                : Words::tr("This device renders no force: the force is shown beside the scene.");
}

QString stopKeys(bool felt) {
    return felt
               ? Words::tr("Space pauses. Esc stops force at once, and R brings it back slowly; Esc again "
                           "asks whether to stop.")
               : Words::tr("Space pauses. Esc stops the trial at once, and R goes on; Esc again asks whether "
                           "to stop the session.");
}

QString stopHint(bool felt) {
    return felt
               ? Words::tr("Esc stops force at once; pressed again, it asks whether to stop the session. T "
                           "frees the pointer.")
               : Words::tr("Esc stops the trial at once; pressed again, it asks whether to stop the session. "
                           "T frees the pointer.");
}

QString stopped(bool felt) {
    return felt ? Words::tr("Force is stopped") : Words::tr("The trial is stopped");
}

QString stop(bool felt) {
    return felt ? Words::tr("Stop force") : Words::tr("Stop the trial");
}

QString goOn(bool felt) {
    return felt ? Words::tr("Re-arm force") : Words::tr("Go on after a stop");
}

} // namespace chiron::desktop::felt_words
