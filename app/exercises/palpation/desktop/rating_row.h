// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>
#include <array>

class QLabel;
class QPushButton;

namespace chiron::desktop {

/// A rating from 1 to 5: five buttons, and above them the name of the rating with the word for the chosen
/// value ("Hardness: firm"). Indicates if the digit keys set this row.
/// Thread: GUI.
class RatingRow final : public QWidget {
    Q_OBJECT
public:
    using Word = QString (*)(int rating);

    RatingRow(const Theme& theme, const QString& name, Word word, QWidget* parent = nullptr);

    void setRating(int rating); ///< 0: none yet
    void setKeysHere(bool here);
    QString words() const; ///< "Hardness: firm"

signals:
    void rated(int rating); ///< a button was pressed

private:
    QString m_name;
    Word m_word;
    QLabel* m_title;
    QLabel* m_keys;
    std::array<QPushButton*, 5> m_buttons{};
    int m_rating = -1;
};

} // namespace chiron::desktop
