// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// What somebody typed into the field of a number.
struct ReadQuantity {
    enum class Fault {
        none,
        empty,
        noNumber, ///< "abc", "1,5,2"
        otherUnit ///< a unit that is none, or of something else: "0.3 kg" for a stiffness
    };
    Fault fault = Fault::none;
    double value = 0.0; ///< in the field's unit
};

/// A number, with or without a unit of the same dimension: "0.3 N/mm" for N/m is 300. Without one it is in `unit` (empty: a plain number). Numbers
/// are read as people of the locale write them, and with points or commas where that is not ambiguous. Pure.
ReadQuantity readQuantity(const QString& text, const QString& unit, const QLocale& locale);

} // namespace chiron::desktop
