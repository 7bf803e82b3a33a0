// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "psychophysics/study/arrangement.h"
#include "psychophysics/study/attribute.h"

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;

namespace chiron::desktop {

/// Lets a participant answer a task: the question and a button for each answer, all usable by keyboard (1 2
/// 3, =, Y N, + −, Enter). It contains no value or name of a condition.
/// Thread: GUI.
class AnswerPanel final : public QWidget {
    Q_OBJECT
public:
    AnswerPanel(const Theme& theme, psychophysics::Task task, psychophysics::Attribute attribute,
                QWidget* parent = nullptr);

    /// Whether an answer is accepted now; if not, `why` says what is missing (may be empty).
    void setOpen(bool open, const QString& why = {});
    void clear(); ///< prepares for the next trial
    /// The keys that answer (Qt::Key). Enter is passed to enterKey().
    static std::vector<int> keys();
    bool key(int key); ///< false: the key is not used here
    void enterKey();
    /// The current ranking as marks for the places ("least" ...; with ties "1 =", ...); empty if the task is
    /// not a ranking.
    QStringList marks() const;
    QString question() const;

    static QStringList placeNames(int places);

signals:
    void begun(); ///< the first key or click of an answer
    void answered(int answer, std::optional<double> value);
    void adjusted(int steps);
    void marksChanged();

protected:
    void showEvent(QShowEvent* event) override;

private:
    QPushButton* add(const QString& text, const QString& name, const char* kind = "");
    QPushButton* addPlace(int place, int places);
    void buildRanking();
    void choose(int index);
    void rank(int place);
    void setNextEqual(bool equal);
    void confirm();
    void takeBack();
    void showRanking();

    const Theme& m_theme;
    psychophysics::Task m_task;
    psychophysics::Attribute m_attribute;
    bool m_open = false;
    QString m_whyText;
    QLabel* m_why = nullptr;
    QWidget* m_row = nullptr;
    std::vector<QPushButton*> m_choices;
    QPushButton* m_confirm = nullptr;
    QPushButton* m_back = nullptr;
    QPushButton* m_equal = nullptr; ///< with ties: the next object feels the same as the last
    QLineEdit* m_number = nullptr;
    std::vector<int> m_order;         ///< ranking: places from least to most, so far
    psychophysics::Ranking m_ranks{}; ///< ranks of those places
    bool m_nextEqual = false;
};

} // namespace chiron::desktop
