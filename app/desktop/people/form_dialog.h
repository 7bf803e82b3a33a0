// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QDialog>

class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

class AppContext;
class NoticeArea;
class ScrollPage;

/// A dialog with a form that scrolls, a notice, and two buttons: do it, or leave it. Deleted when closed. While working it
/// stays open and cannot be sent twice. GUI thread.
class FormDialog : public QDialog {
    Q_OBJECT
public:
    FormDialog(AppContext& context, const QString& objectName, const QString& title, QWidget* parent);

    void reject() override; ///< not while working

signals:
    void changed(); ///< something was stored: lists are out of date

protected:
    AppContext& context() const { return m_context; }
    const Theme& theme() const;
    QVBoxLayout* column() const { return m_form; }
    /// Object name of the button is "<dialog>.accept".
    void setAccept(const QString& text, const char* kind = "primary");
    void setCancel(const QString& text); ///< what leaving means, where "Cancel" does not say it
    void setAcceptable(bool acceptable); ///< the form is complete
    /// What cannot be undone and asks for nothing to be typed: Enter leaves it. After setAccept.
    void cancelAtEnter();
    /// Scrolls to a part of the form, for whoever comes to it by a key.
    void reveal(QWidget& part);
    /// While working the form cannot be used, unless it shows the progress itself.
    void setWorking(bool working, bool formShowsIt = false);
    bool isWorking() const { return m_working; }
    /// kind as in kit::notice; an empty text says nothing.
    void say(const char* kind, const QString& text);
    /// The work is done: the form goes, this comes, and only "Close" is left.
    void showResult(QWidget* result);
    /// The same for what is shown this once: `first`, which takes it along, has the focus, so that Enter does not close.
    void showSecret(QWidget* result, QPushButton* first);
    /// Only the way out that the form has itself is left; Escape and the window's own button still ask reject().
    void hideCancel();
    /// There is nothing to do: only "Close" is left. False: both buttons again.
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
    bool m_acceptable = false;
    bool m_working = false;
};

} // namespace chiron::desktop
