// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"

#include <QtTest>

namespace chiron::tests {

/// A row for every level of every exercise: "exercise" and "number", named "exercise/number".
inline void addLevelRows(const catalogue::Catalogue& catalogue) {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("number");
    for (const catalogue::Exercise& exercise : catalogue.exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            QTest::newRow((exercise.id + "/" + std::to_string(level.number)).c_str())
                << QString::fromStdString(exercise.id) << level.number;
}

} // namespace chiron::tests
