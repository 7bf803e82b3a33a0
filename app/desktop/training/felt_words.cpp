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

} // namespace chiron::desktop::felt_words
