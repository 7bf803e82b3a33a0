// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QDialog>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

class AppContext;
class NoticeArea;
class ScrollPage;

/// A dialog with a scrolling form, a notice, and two buttons to accept or cancel. It is deleted when closed.
/// While it is working it stays open and cannot be submitted again.
/// Thread: GUI.
class FormDialog : public QDialog {
    Q_OBJECT
public:
    FormDialog(AppContext& context, const QString& objectName, const QString& title, QWidget* parent);

    void reject() override; ///< ignored while working

signals:
    void changed(); ///< something was stored: lists must reload

protected:
    AppContext& context() const { return m_context; }
    const Theme& theme() const;
    QVBoxLayout* column() const { return m_form; }
    /// Object name of the button is "<dialog>.accept".
    void setAccept(const QString& text, const char* kind = "primary");
    void setCancel(const QString& text); ///< a label for cancelling where "Cancel" is unclear
    /// `acceptable`: the form is complete. Otherwise `whyNot` stands beside the button: the reason, and what
    /// to do.
    void setAcceptable(bool acceptable, const QString& whyNot = {});
    /// For actions that cannot be undone and require no typing: makes Cancel the default button, so that
    /// Enter cancels. Call it after setAccept().
    void cancelAtEnter();
    /// Scrolls to a part of the form, for a person who reaches it by keyboard.
    void reveal(QWidget& part);
    /// While working, the form is disabled unless it shows the progress itself (`formShowsIt`).
    void setWorking(bool working, bool formShowsIt = false);
    bool isWorking() const { return m_working; }
    /// `kind` as in kit::notice. An empty text hides the notice.
    void say(const char* kind, const QString& text);
    /// Replaces the form with the result once the work is done. Only "Close" remains.
    void showResult(QWidget* result);
    /// The same for a result that is shown only once: `first`, the button that saves it, has the focus, so
    /// that Enter does not close the dialog.
    void showSecret(QWidget* result, QPushButton* first);
    /// Hides Cancel if the form has its own way out. Escape and the window's close button still call
    /// reject().
    void hideCancel();
    /// True: there is nothing to do, so only "Close" remains. False: shows both buttons again.
    void leaveOnly(bool only);
    virtual void submit() = 0;

private:
    void renew();

    AppContext& m_context;
    ScrollPage* m_page;
    QWidget* m_body;
    QVBoxLayout* m_form;
    NoticeArea* m_notice;
    QPushButton* m_accept;
    QPushButton* m_cancel;
    QHBoxLayout* m_buttons;
    QLabel* m_whyNot = nullptr; ///< made when there is something to say
    bool m_acceptable = false;
    bool m_working = false;
};

} // namespace chiron::desktop
