// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"

#include <string>

namespace chiron::database {

/// A person as account lists show them.
struct Person {
    PersonId id = 0;
    std::string name; ///< login name, unique after case folding
    std::string displayName;
    std::string code; ///< pseudonym used in studies and for readers who may not see names
    RoleSet roles;
    bool enabled = true;
    bool mustChangePassword = false;
    std::string createdUtc;
};

/// The names that a person had before a change of name.
struct EarlierName {
    std::int64_t id = 0;
    std::string name;
    std::string displayName;
    std::string untilUtc;
    PersonId changedBy = 0;
};

/// A login name and a full name that a person had before either was changed.
struct EarlierLogin {
    PersonId person = 0;
    std::string name;
    std::string displayName{}; ///< may be empty
};

/// An entry of the login screen, without e-mail, roles or code.
struct LoginName {
    PersonId id = 0;
    std::string name;        ///< login name
    std::string displayName; ///< may be empty
};

/// A person to be created. The password is already hashed (PasswordHasher), so that no writer job waits for
/// Argon2id.
struct NewPerson {
    std::string name;
    std::string displayName;
    RoleSet roles;
    std::string passwordHash;
    bool mustChangePassword = false;
};

/// A change that a list of people makes to an existing account; the login name and the password do not
/// change.
struct PersonChange {
    PersonId id = 0;
    std::string displayName;
    RoleSet roles;
};

/// One stored attempt to log in, between beginLogin and finishLogin.
struct LoginAttempt {
    /// 0: no such account; something is hashed anyway, so that it takes the same time.
    PersonId person = 0;
    std::string passwordHash; ///< hash to verify against (password or recovery code); empty if there is none
    std::int64_t wait_ns = 0; ///< > 0: the account must wait this long; nothing was counted
    std::int64_t waitIfWrong_ns = 0; ///< how long the next attempt must wait if this one is wrong
};

/// Why a login was refused.
struct Refusal {
    enum class Kind : std::uint8_t {
        wrong,    ///< name, password or code; it is not revealed which
        mustWait, ///< too many wrong attempts: this one was not checked
        disabled, ///< the password is right
        failed    ///< anything else: storage, rules; see error
    };
    Kind kind = Kind::failed;
    std::int64_t wait_ns = 0; ///< time before the next attempt is checked
    core::Error error;
};

} // namespace chiron::database
